#pragma once

#include <functional>
#include <string>

namespace modeling {

/// How someone waits while something takes its time. Both are called in the thread that works, a few times a
/// second; both may be left out.
struct Attendance {
  /// Is told what goes on, in words for a person: "reading cup.fbx, 3 s".
  std::function<void(const std::string& words)> tell;
  /// True: nobody waits any more, so that the work ends as soon as it can.
  std::function<bool()> gaveUp;
};

}  // namespace modeling
