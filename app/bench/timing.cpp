#include "app/bench/timing.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <vector>

namespace app {
namespace {

double medianOf(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

}  // namespace

Seconds secondsNow() {
  return {std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(),
          static_cast<double>(std::clock()) / CLOCKS_PER_SEC};
}

Seconds medianSeconds(int repeats, const std::function<void()>& work) {
  work();
  std::vector<double> wall;
  std::vector<double> cpu;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const Seconds start = secondsNow();
    work();
    const Seconds end = secondsNow();
    wall.push_back(end.wall - start.wall);
    cpu.push_back(end.cpu - start.cpu);
  }
  return {medianOf(wall), medianOf(cpu)};
}

double threadSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace app
