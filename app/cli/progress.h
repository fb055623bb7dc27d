#pragma once

#include <string>

namespace app {

/// A line on standard error that says how much of a thing is done and how long the rest may take, rewritten
/// in place. Silent where standard error is no terminal.
class Progress {
 public:
  explicit Progress(std::string what);
  /// Wipes the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// share in [0, 1]. Shown at most ten times a second, so that it may be told as often as one likes.
  void show(double share, const std::string& detail = "");
  /// A call of show() now would be seen.
  bool isDue() const;
  /// s since it began, by the clock on the wall.
  double elapsed() const;
  /// Of a thing of which nobody knows how long it takes.
  void begin();

 private:
  std::string what_;
  bool terminal_;
  double start_;
  double lastShown_ = 0.0;
};

/// s: nobody starts on purpose what takes longer.
inline constexpr double kVeryLong = 86400.0;

/// "40 s", "3 min", "2.5 h", "12 days".
std::string roughTime(double seconds);

}  // namespace app
