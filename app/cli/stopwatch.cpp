#include "app/cli/stopwatch.h"

#include <chrono>
#include <ctime>

namespace app {
namespace {

double wallClock() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

double cpuClock() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

Stopwatch::Stopwatch() : wallStart_(wallClock()), cpuStart_(cpuClock()) {}

double Stopwatch::wallSeconds() const {
  return wallClock() - wallStart_;
}

double Stopwatch::cpuSeconds() const {
  return cpuClock() - cpuStart_;
}

}  // namespace app
