#pragma once

#include <string>

#include "modeling/import/attendance.h"

namespace app {

/// Says on standard error what is waited for, such as a large file: on a terminal as a line that is
/// rewritten, else once. Who does not want to wait ends the program, and what it has started ends with it.
class Waiting {
 public:
  Waiting();
  /// Wipes the line.
  ~Waiting();
  Waiting(const Waiting&) = delete;
  Waiting& operator=(const Waiting&) = delete;

  /// It may be used while this is there.
  modeling::Attendance attendance();

 private:
  void show(const std::string& words);

  bool terminal_;
  bool shown_ = false;
};

}  // namespace app
