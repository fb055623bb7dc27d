#include "ui/session/preflight_run.h"

#include <mutex>

#include "ui/session/background.h"

namespace ui {

struct PreflightRun::Shared {
  mutable std::mutex mutex;
  bool done = false;
  std::optional<modeling::Preflight> result;
  std::optional<sim::Problem> problem;
};

PreflightRun::~PreflightRun() {
  runner_.request_stop();
  // Finding the stable step of something large takes longer than a person waits for a window to close; what
  // it works on is its own.
  if (runner_.joinable() && !isDone()) runner_.detach();
}

void PreflightRun::start(const std::shared_ptr<const Preview>& preview) {
  runner_.request_stop();
  if (runner_.joinable()) runner_.detach();
  shared_ = std::make_shared<Shared>();
  runner_ = std::jthread([shared = shared_, preview](const std::stop_token& stop) {
    giveWayToTheWindow();
    sim::Result<modeling::Preflight> result = sim::Problem{"", "there is nothing to simulate", "add a part"};
    try {
      if (preview->problem) result = *preview->problem;
      if (preview->built) {
        result =
            modeling::preflight(preview->scene, *preview->built, 0, [&] { return !stop.stop_requested(); });
      }
    } catch (const std::exception& exception) {
      result = sim::Problem{"", std::string("this could not be found out: ") + exception.what(), ""};
    }
    const std::lock_guard lock(shared->mutex);
    shared->done = true;
    if (result) {
      shared->result = *result;
    } else {
      shared->problem = result.problem();
    }
  });
}

bool PreflightRun::isDone() const {
  if (!shared_) return false;
  const std::lock_guard lock(shared_->mutex);
  return shared_->done;
}

std::optional<modeling::Preflight> PreflightRun::result() const {
  if (!shared_) return std::nullopt;
  const std::lock_guard lock(shared_->mutex);
  return shared_->result;
}

std::optional<sim::Problem> PreflightRun::problem() const {
  if (!shared_) return std::nullopt;
  const std::lock_guard lock(shared_->mutex);
  return shared_->problem;
}

}  // namespace ui
