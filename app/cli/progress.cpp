#include "app/cli/progress.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <utility>

#include <unistd.h>

namespace app {
namespace {

constexpr const char* kWipeLine = "\r\x1b[K";
constexpr double kSecondsBetween = 0.1;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Progress::Progress(std::string what)
    : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) == 1), start_(now()) {}

Progress::~Progress() {
  if (terminal_ && lastShown_ > 0.0) std::cerr << kWipeLine << std::flush;
}

void Progress::show(double share, const std::string& detail) {
  const double moment = now();
  if (!terminal_ || moment - lastShown_ < kSecondsBetween) return;
  lastShown_ = moment;
  const double done = std::clamp(share, 0.0, 1.0);
  const int percent = static_cast<int>(100.0 * done);
  std::cerr << kWipeLine << what_ << "  " << percent << " %" << (detail.empty() ? "" : ", ") << detail;
  if (done > 0.0) std::cerr << ", " << static_cast<int>((moment - start_) * (1.0 - done) / done) << " s left";
  std::cerr << std::flush;
}

}  // namespace app
