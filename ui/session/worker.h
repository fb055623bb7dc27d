#pragma once

#include <memory>

#include "ui/session/background_thread.h"
#include "ui/session/run.h"

namespace ui {

/// The thread that owns the simulation. The window gives it orders and reads views; neither ever waits for
/// the other: orders are taken between two steps, and a view is a pointer to something that never changes.
///
/// Every function may be called from any thread and returns at once. No lock is held across a step.
class Worker {
 public:
  Worker();

  /// Ends the present run, keeping what it recorded, and begins this one. Answers its number.
  std::uint64_t start(RunPlan plan);
  void setPaused(bool paused);
  /// One step, or to the next frame, of a paused run.
  void stepOnce();
  void stepFrame();
  /// Ends the run; what was recorded is kept.
  void stop();
  void setPace(const Pace& pace);
  /// Acts from the next step on, and is listed in RunView::performed with the moments it got. Times of the
  /// keys ascend and count from that step; each value holds until the next.
  void perform(const modeling::TargetName& target, std::vector<modeling::SceneTrackKey> keys);
  /// Lets an invisible collider come, go along a path and vanish; times of the path count from the next step.
  void performCollider(const modeling::SceneCollider& prototype, std::vector<modeling::SceneTrackKey> path);

  std::shared_ptr<const RunView> view() const;
  /// See BackgroundThread::requestStop(). The take is whole up to its last frame, however it ends.
  void requestStop() { thread_.requestStop(); }

 private:
  class Queue;
  std::shared_ptr<Queue> queue_;  ///< shared with the thread, which may outlive this
  BackgroundThread thread_;
};

}  // namespace ui
