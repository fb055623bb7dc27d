#include "ui/session/preflight_run.h"

namespace ui {

PreflightRun::PreflightRun()
    : worker_([](const std::shared_ptr<const Preview>& preview, auto& job) -> sim::Status {
        if (preview->problem) return *preview->problem;
        if (!preview->built) return sim::Problem{"", "there is nothing to simulate", "add a part"};
        const auto found =
            modeling::preflight(preview->scene, *preview->built, 0, [&job] { return !job.cancelled(); });
        if (!found) return found.problem();
        job.value = *found;
        return sim::Done{};
      }) {}

void PreflightRun::start(const std::shared_ptr<const Preview>& preview) {
  started_ = worker_.request(preview);
}

bool PreflightRun::isDone() const {
  const auto answer = worker_.newest();
  return started_ > 0 && answer->request == started_ && answer->ended;
}

std::optional<modeling::Preflight> PreflightRun::result() const {
  return isDone() ? worker_.newest()->value : std::nullopt;
}

std::optional<sim::Problem> PreflightRun::problem() const {
  return isDone() ? worker_.newest()->problem : std::nullopt;
}

}  // namespace ui
