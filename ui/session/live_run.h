#pragma once

#include <chrono>
#include <functional>
#include <memory>

#include "ui/session/run.h"

namespace ui {

/// One run as the worker's thread drives it: prepares the simulation, steps it in slices short enough to obey
/// orders between them, records frames, and describes itself. Not thread-safe.
class LiveRun {
 public:
  using Clock = std::chrono::steady_clock;
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
  /// Finishes the take. What is done or failed stays so.
  void stop();
  void fail(const sim::Problem& problem);
  void setPace(const Pace& pace);
  void perform(const modeling::TargetName& target, const std::vector<modeling::SceneTrackKey>& keys);
  void performCollider(const modeling::SceneCollider& prototype, std::vector<modeling::SceneTrackKey> path);

  /// Null where nothing is to be told that the last one did not tell, or it is too early to tell it.
  std::shared_ptr<const RunView> newView();

 private:
  sim::Status startFresh();
  sim::Status startContinued(const Interrupt& cancelled);
  sim::Status showCopiedFrames(const sim::TakeReader& reader);
  sim::Status startTake();
  bool ended() const;
  /// False when the simulation failed.
  bool stepTowards(double frame);
  sim::Status recordFrame();
  sim::Status writeFrame(const sim::Snapshot& moment);
  sim::Status writeScene();
  void pauseBecause(const sim::Problem& problem);
  bool retry();
  void finish(const std::string& outcome);
  void replan(std::vector<Performed> performed);
  void restartPace();
  void restartClock();
  double secondsAhead() const;
  void look();

  std::uint64_t number_;
  RunPlan plan_;
  Pace pace_;
  RunPhase phase_ = RunPhase::preparing;
  bool pauseAtFrame_ = false;
  std::unique_ptr<sim::Simulation> simulation_;
  std::unique_ptr<sim::TakeWriter> take_;
  std::shared_ptr<Footage> footage_;
  modeling::Scene scene_;     ///< as performed so far
  bool sceneWritten_ = true;  ///< the take's scene is this one
  std::vector<sim::BreakEvent> unrecorded_;
  std::uint64_t framesSinceCheckpoint_ = 0;
  std::vector<Performed> performed_;
  std::vector<std::string> notes_;
  std::optional<sim::Problem> problem_;
  bool unwritten_ = false;  ///< the frame of this very moment could not be recorded

  Clock::time_point paceStart_;   ///< when the clock of the pace was started,
  double paceTime_ = 0.0;         ///< s: and at which moment of the simulation
  double secondsPerStep_ = 1e-4;  ///< of the clock, lately
  double realTimeFactor_ = 0.0;
  Clock::time_point frameStart_;  ///< when the last frame was recorded, or the run began or went on,
  double frameTime_ = 0.0;        ///< s: at this moment of the simulation
  sim::Work frameWork_;           ///< and by then this had been done

  sim::SnapshotPointer newest_;
  bool changed_ = true;  ///< something is to be told at once
  Clock::time_point toldAt_;
  Clock::duration tellingTook_{};
};

}  // namespace ui
