#include "ui/session/run_clocks.h"

#include <algorithm>
#include <cmath>

namespace ui {
namespace {

using namespace std::chrono_literals;
using Seconds = std::chrono::duration<double>;

/// Views are made for a screen: no more often than it is drawn, and taking no more than a tenth of the time.
constexpr auto kViewInterval = 15ms;
constexpr int kViewShare = 9;
/// Of the past in measured rates, at each measurement.
constexpr double kInertia = 0.8;
/// s of the clock: how far a run may be behind its pace and still try to catch up.
constexpr double kForgiven = 0.1;

}  // namespace

void PaceClock::restart(double time) {
  start_ = Clock::now();
  startTime_ = time;
}

void PaceClock::setPace(const Pace& pace, double time) {
  pace_ = pace;
  restart(time);
}

double PaceClock::secondsAhead(double time) const {
  if (!pace_.timeScale) return 0.0;
  return (time - startTime_) / *pace_.timeScale - Seconds(Clock::now() - start_).count();
}

Clock::time_point PaceClock::due(double time) const {
  const double ahead = std::clamp(secondsAhead(time), 0.0, 1.0);
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(Seconds(ahead));
}

void PaceClock::forgiveDelay(double time) {
  if (secondsAhead(time) < -kForgiven) restart(time);
}

FrameNote SpeedMeter::noteFrame(const sim::Simulation& simulation, bool first) {
  FrameNote note;
  const Clock::time_point now = Clock::now();
  const double elapsed = Seconds(now - start_).count();
  if (!first && elapsed > 0.0) {
    note.realTimeFactor = (simulation.time() - startTime_) / elapsed;
    const double past = realTimeFactor_ > 0.0 ? kInertia : 0.0;
    realTimeFactor_ = past * realTimeFactor_ + (1.0 - past) * note.realTimeFactor;
  }
  const sim::Work& work = simulation.work();
  note.bondsEvaluated = work.bondsEvaluated - work_.bondsEvaluated;
  note.bondsSkipped = work.bondsSkipped - work_.bondsSkipped;
  work_ = work;
  start_ = now;
  startTime_ = simulation.time();
  return note;
}

sim::Status ShortAdvance::advance(sim::Simulation& simulation, double until, double seconds) {
  const std::uint64_t before = simulation.stepCount();
  const Clock::time_point start = Clock::now();
  const double steps = std::clamp(std::floor(seconds / secondsPerStep_), 1.0, 1000.0);
  const double target = std::min(until, simulation.time() + (steps - 0.5) * simulation.step());
  const sim::Status status = simulation.advanceTo(target);
  const auto made = static_cast<double>(std::max<std::uint64_t>(simulation.stepCount() - before, 1));
  const double took = Seconds(Clock::now() - start).count() / made;
  secondsPerStep_ = std::max(kInertia * secondsPerStep_ + (1.0 - kInertia) * took, 1e-7);
  return status;
}

bool ViewSchedule::isDue() const {
  const auto wait = std::max<Clock::duration>(kViewInterval, kViewShare * tellingTook_);
  return Clock::now() - toldAt_ >= wait;
}

void ViewSchedule::told(Clock::time_point begun) {
  urgent_ = false;
  toldAt_ = Clock::now();
  tellingTook_ = toldAt_ - begun;
}

}  // namespace ui
