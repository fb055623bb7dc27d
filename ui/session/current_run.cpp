#include "ui/session/current_run.h"

#include <utility>

namespace ui {

void CurrentRun::start(RunPlan plan, TakeLabel label) {
  label_ = std::move(label);
  takeGiven_ = false;
  performedGiven_ = 0;
  number_ = worker_.start(std::move(plan));
  auto preparing = std::make_shared<RunView>();
  preparing->run = number_;
  preparing->phase = RunPhase::preparing;
  view_ = std::move(preparing);
}

void CurrentRun::forget() {
  worker_.stop();
  number_ = 0;
}

bool CurrentRun::poll() {
  std::shared_ptr<const RunView> view = worker_.view();
  // What the worker told last may be of a run before the one that was just asked for.
  if (view == view_ || view->run < view_->run) return false;
  view_ = std::move(view);
  return true;
}

bool CurrentRun::isPreparingOrRunning() const {
  return isTold() && (view_->phase == RunPhase::running || view_->phase == RunPhase::preparing);
}

bool CurrentRun::isRunningOrPaused() const {
  return isPreparingOrRunning() || (isTold() && view_->phase == RunPhase::paused);
}

std::optional<Take> CurrentRun::newTake() {
  if (!isTold() || !view_->footage || std::exchange(takeGiven_, true)) return std::nullopt;
  Take take;
  static_cast<TakeLabel&>(take) = label_;
  take.made = QDateTime::currentDateTime();
  take.footage = view_->footage;
  take.own = true;
  return take;
}

std::span<const Performed> CurrentRun::newlyPerformed() {
  if (!isTold()) return {};
  const std::size_t from = std::exchange(performedGiven_, view_->performed.size());
  return std::span(view_->performed).subspan(from);
}

}  // namespace ui
