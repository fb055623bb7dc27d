#include "app/cli/progress.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
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

bool Progress::isDue() const {
  return terminal_ && now() - lastShown_ >= kSecondsBetween;
}

double Progress::elapsed() const {
  return now() - start_;
}

void Progress::begin() {
  if (!terminal_) return;
  lastShown_ = now();
  std::cerr << kWipeLine << what_ << std::flush;
}

void Progress::show(double share, const std::string& detail) {
  if (!isDue()) return;
  lastShown_ = now();
  const double done = std::clamp(share, 0.0, 1.0);
  const int percent = static_cast<int>(100.0 * done);
  std::cerr << kWipeLine << what_ << "  " << percent << " %" << (detail.empty() ? "" : ", ") << detail;
  if (done > 0.0) std::cerr << ", " << roughTime(elapsed() * (1.0 - done) / done) << " left";
  std::cerr << std::flush;
}

std::string roughTime(double seconds) {
  struct Unit {
    double seconds;
    double upTo;  ///< s
    const char* format;
  };
  static constexpr std::array<Unit, 4> kUnits{{{1.0, 90.0, "%.0f s"},
                                               {60.0, 5400.0, "%.0f min"},
                                               {3600.0, 172800.0, "%.1f h"},
                                               {86400.0, 1e300, "%.3g days"}}};
  const auto unit =
      std::find_if(kUnits.begin(), kUnits.end() - 1, [&](const Unit& each) { return seconds < each.upTo; });
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), unit->format, seconds / unit->seconds);
  return text.data();
}

}  // namespace app
