#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace tests {

struct Bounds {
  double seconds = 20.0;                       ///< by the clock
  std::size_t memory = std::size_t{2} << 30U;  ///< bytes, beyond what the process has; not with sanitizers
};

/// How a trial ended.
struct Ending {
  bool sound = false;  ///< it ended by itself, and what it found is no fault
  std::string
      words;  ///< what it found, or how it ended: "CRASHED by signal 11", "HUNG", "MEMORY", "THREW: ..."
};

/// Runs the trial in a process of its own. Its answer is one whose words do not begin with "WRONG".
Ending runBounded(const std::function<std::string()>& trial, const Bounds& bounds);

}  // namespace tests
