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

  /// share in [0, 1]. Shown at most ten times a second.
  void show(double share, const std::string& detail = "");

 private:
  std::string what_;
  bool terminal_;
  double start_;
  double lastShown_ = 0.0;
};

}  // namespace app
