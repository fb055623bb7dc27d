#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "sim/dynamics/simulation.h"
#include "sim/take/take.h"

namespace app {

/// Seconds on the clock and on all processors.
struct Stopwatch {
  Stopwatch();
  double wallSeconds() const;
  double cpuSeconds() const;

 private:
  double wallStart_;
  double cpuStart_;
};

/// Runs a simulation to its end and records it. Frames fall on the first step at or after k /
/// framesPerSecond, frame 0 at the start; no step is two frames. The end is a frame, too, whether or not it
/// falls on one, so that it can be resumed.
///
/// Where frames and checkpoints fall has no influence on the motion, and follows from the simulation's time
/// alone, so that a resumed run goes on as the unbroken one would have.
class Recorder {
 public:
  /// Called after each frame.
  using Watcher = std::function<void(const sim::Simulation&)>;

  /// `take` may be nullptr. A take that is continued has the simulation's present state as its last frame
  /// already.
  Recorder(sim::Simulation& simulation, sim::TakeWriter* take, double framesPerSecond);

  /// Records the state at the start.
  sim::Status begin();
  /// What happened before a resumed run went on.
  void takeOver(const std::vector<sim::BreakEvent>& events);
  /// Runs to `until` (s) and finishes the take. A Problem of the simulation (a blow-up) ends the take with
  /// its words.
  sim::Status run(double until, const Watcher& watcher);

  std::optional<double> firstBreak() const { return firstBreak_; }  ///< s
  std::uint64_t breaks() const { return breaks_; }
  std::uint64_t nodesLeftOut() const { return take_ == nullptr ? 0 : take_->nodesLeftOut(); }

 private:
  sim::Status advance(double until, const Watcher& watcher);
  sim::Status record(bool last);
  double nextFrameTime() const;
  void count(const std::vector<sim::BreakEvent>& events);

  sim::Simulation& simulation_;
  sim::TakeWriter* take_;
  double framesPerSecond_;
  std::uint64_t framesSinceCheckpoint_ = 0;
  std::optional<double> firstBreak_;
  std::uint64_t breaks_ = 0;
};

}  // namespace app
