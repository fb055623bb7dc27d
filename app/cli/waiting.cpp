#include "app/cli/waiting.h"

#include <iostream>

#include <unistd.h>

namespace app {
namespace {

constexpr const char* kWipeLine = "\r\x1b[K";

}  // namespace

Waiting::Waiting() : terminal_(isatty(STDERR_FILENO) == 1) {}

Waiting::~Waiting() {
  if (terminal_ && shown_) std::cerr << kWipeLine << std::flush;
}

modeling::Attendance Waiting::attendance() {
  return {[this](const std::string& words) { show(words); }, {}};
}

void Waiting::show(const std::string& words) {
  if (terminal_) {
    std::cerr << kWipeLine << words << " (Ctrl+C gives up)" << std::flush;
  } else if (!shown_) {
    std::cerr << words << '\n';
  }
  shown_ = true;
}

}  // namespace app
