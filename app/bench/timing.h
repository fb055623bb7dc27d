#pragma once

#include <functional>

namespace app {

/// Median of the seconds that `repeats` calls of `work` take, after one that does not count.
double medianSeconds(int repeats, const std::function<void()>& work);

}  // namespace app
