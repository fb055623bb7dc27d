#pragma once

#include <chrono>
#include <optional>

#include "sim/dynamics/simulation.h"
#include "ui/session/footage.h"
#include "ui/session/run.h"

/// How a run keeps to the clock on the wall. Not thread-safe.
namespace ui {

using Clock = std::chrono::steady_clock;

/// Keeps a run from going faster than its pace.
class PaceClock {
 public:
  explicit PaceClock(const Pace& pace) : pace_(pace) {}

  /// Begins anew at a moment of the simulation (s).
  void restart(double time);
  void setPace(const Pace& pace, double time);
  /// How far the simulation is ahead of its pace, in seconds of the clock; 0 where it has none.
  double secondsAhead(double time) const;
  /// When the simulation may go on.
  Clock::time_point due(double time) const;
  /// A computer too slow for the pace does not try to catch up later.
  void forgiveDelay(double time);

 private:
  Pace pace_;
  Clock::time_point start_ = Clock::now();
  double startTime_ = 0.0;  ///< s: the moment of the simulation at `start_`
};

/// Measures how fast frames are made.
class SpeedMeter {
 public:
  /// Begins anew where a run begins or goes on. `work`: what had been done before.
  void restart(double time) {
    start_ = Clock::now();
    startTime_ = time;
  }
  void setWork(const sim::Work& work) { work_ = work; }
  /// What is to be noted of the frame just made. `first`: no frame came before it.
  FrameNote noteFrame(const sim::Simulation& simulation, bool first);
  /// Simulated seconds a second of the clock, lately; 0: not known.
  double realTimeFactor() const { return realTimeFactor_; }

 private:
  Clock::time_point start_;  ///< of the frame that is being made
  double startTime_ = 0.0;   ///< s: the moment of the simulation at `start_`
  sim::Work work_;           ///< done by then
  double realTimeFactor_ = 0.0;
};

/// Advances a few steps at a time, so that the clock is not asked after each of many short ones.
class ShortAdvance {
 public:
  /// Towards a moment (s), for about `seconds` of the clock, and one step at least.
  sim::Status advance(sim::Simulation& simulation, double until, double seconds);

 private:
  double secondsPerStep_ = 1e-4;  ///< of the clock, lately
};

/// Says when the window is to be told what the run is like.
class ViewSchedule {
 public:
  void tellAtOnce() { urgent_ = true; }
  bool isUrgent() const { return urgent_; }
  /// It is time to tell what is not urgent.
  bool isDue() const;
  /// The window has been told; making the view began then.
  void told(Clock::time_point begun);

 private:
  bool urgent_ = true;
  Clock::time_point toldAt_;
  Clock::duration tellingTook_{};
};

}  // namespace ui
