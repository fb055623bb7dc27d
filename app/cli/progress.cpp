#include "app/cli/progress.h"

#include <iostream>
#include <utility>

#include <unistd.h>

namespace app {

namespace {

constexpr const char* kWipeLine = "\r\x1b[K";

}  // namespace

Progress::Progress(std::string what) : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (terminal_ && percent_ >= 0) std::cerr << kWipeLine << std::flush;
}

void Progress::show(double share) {
  const int percent = static_cast<int>(100.0 * share);
  if (!terminal_ || percent == percent_) return;
  percent_ = percent;
  std::cerr << kWipeLine << what_ << "  " << percent << " %" << std::flush;
}

}  // namespace app
