#pragma once

#include <string>

namespace app {

/// A line on standard error that says how much of a thing is done, rewritten in place. Silent where standard
/// error is no terminal.
class Progress {
 public:
  explicit Progress(std::string what);
  /// Wipes the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// share in [0, 1]; prints at whole percents only.
  void show(double share);

 private:
  std::string what_;
  bool terminal_;
  int percent_ = -1;
};

}  // namespace app
