#pragma once

#include <functional>

namespace app {

/// Seconds of a clock on the wall, and of the processor, all threads together.
struct Seconds {
  double wall = 0.0;
  double cpu = 0.0;
};

Seconds secondsNow();

/// Median of the seconds that `repeats` calls of `work` take, after one that does not count.
Seconds medianSeconds(int repeats, const std::function<void()>& work);

/// Seconds this thread has computed so far: what others do on the machine does not count.
double threadSeconds();

}  // namespace app
