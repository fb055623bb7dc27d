#pragma once

#include <memory>
#include <optional>
#include <span>

#include "ui/session/take_list.h"
#include "ui/session/worker.h"

namespace ui {

/// The run that was started last, as the window's thread knows it.
class CurrentRun {
 public:
  CurrentRun() : view_(std::make_shared<const RunView>()) {}

  /// Ends the run before. `label` becomes that of the take.
  void start(RunPlan plan, TakeLabel label);
  /// Ends it, and tells no more of it.
  void forget();
  /// Orders for it; without a run they do nothing.
  Worker& worker() { return worker_; }

  /// Takes the newest view over. False where there is none newer.
  bool poll();
  /// As it was told last; never null. It may still be of a run before.
  const std::shared_ptr<const RunView>& view() const { return view_; }
  bool isTold() const { return view_->run == number_; }
  bool isPreparingOrRunning() const;
  bool isRunningOrPaused() const;

  /// Its take, once, as soon as there is one.
  std::optional<Take> newTake();
  /// What was performed since the last call.
  std::span<const Performed> newlyPerformed();

 private:
  std::shared_ptr<const RunView> view_;
  std::uint64_t number_ = 0;  ///< 0: none
  TakeLabel label_;
  bool takeGiven_ = false;
  std::size_t performedGiven_ = 0;
  Worker worker_;
};

}  // namespace ui
