#pragma once

#include <functional>
#include <memory>

#include "ui/session/run.h"
#include "ui/session/run_clocks.h"
#include "ui/session/run_start.h"

namespace ui {

/// One run as the worker's thread drives it: steps the simulation in slices short enough to obey orders
/// between them, records frames, and describes itself. Not thread-safe.
class LiveRun {
 public:
  /// Answers true when the slice is to end early.
  using Interrupt = std::function<bool()>;

  LiveRun(std::uint64_t number, RunPlan plan, const Pace& pace);
  ~LiveRun();
  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;

  /// Builds and records the first frame, then runs.
  void prepare(const Interrupt& cancelled);
  bool isRunning() const { return phase_ == RunPhase::running; }
  /// When there is something to do; nothing: when an order comes.
  std::optional<Clock::time_point> due() const;
  /// Steps for a few milliseconds, or until a frame is recorded or an order waits.
  void advance(const Interrupt& interrupt);

  void setPaused(bool paused);
  /// Runs to the next frame, then pauses.
  void setPausedAtFrame();
  void stepOnce();
  /// Makes the present moment the last frame and finishes the take. What is done or failed stays so.
  void stop();
  void fail(const sim::Problem& problem);
  void setPace(const Pace& pace);
  void perform(const modeling::TargetName& target, const std::vector<modeling::SceneTrackKey>& keys);
  void performCollider(const modeling::SceneCollider& prototype, std::vector<modeling::SceneTrackKey> path);

  /// Null where nothing is to be told that the last one did not tell, or it is too early to tell it.
  std::shared_ptr<const RunView> newView();

 private:
  /// Running or paused.
  bool isActive() const { return phase_ == RunPhase::running || phase_ == RunPhase::paused; }
  sim::Status start(const Interrupt& cancelled);
  bool stepTowards(double frame);
  sim::Status recordFrame();
  void pauseBecause(const sim::Problem& problem);
  bool retry();
  void finish(const std::string& outcome);
  void takeOver(const sim::Status& performed);
  void restartClocks();
  void look();
  double time() const { return run_.simulation ? run_.simulation->time() : 0.0; }

  std::uint64_t number_;
  RunPlan plan_;  ///< spent once the run has started
  RunPhase phase_ = RunPhase::preparing;
  StartedRun run_;  ///< empty until it has started
  std::optional<Performance> performance_;
  std::optional<sim::Problem> problem_;
  bool pauseAtFrame_ = false;
  bool unwritten_ = false;  ///< the frame of this very moment could not be recorded
  PaceClock pace_;
  SpeedMeter speed_;
  ShortAdvance steps_;
  ViewSchedule telling_;
  sim::SnapshotPointer newest_;
};

}  // namespace ui
