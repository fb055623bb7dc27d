#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "modeling/scene/scene.h"
#include "sim/dynamics/simulation.h"

/// What `bench contact` measures of a run. In its scenes part 0 is what lies below, and part 1 what is laid
/// or thrown on it, if there are two.
namespace app {

/// What was measured, in the order in which a measure promises it; nothing: it never came to that.
using ContactValues = std::vector<std::optional<double>>;

struct ContactOutcome {
  ContactValues values;
  double cpuSeconds = 0.0;  ///< of stepping alone
  double maxRise = 0.0;     ///< see sim::Simulation::maxRise()
};

/// A run whose stepping is timed, while looking at it is not.
class TimedRun {
 public:
  explicit TimedRun(std::unique_ptr<sim::Simulation> simulation) : simulation_(std::move(simulation)) {}

  /// A Problem is a blow-up.
  sim::Status to(double time);
  /// Steps until something breaks or `time` is reached.
  sim::Status toBreak(double time);
  /// Steps to `until` and calls `look` that many times on the way, the last time at the end.
  sim::Status looking(int looks, double until, const std::function<void(const sim::Snapshot& now)>& look);

  sim::Simulation& simulation() { return *simulation_; }
  const sim::Network& network() const { return simulation_->network(); }
  double cpuSeconds() const { return cpuSeconds_; }

 private:
  std::unique_ptr<sim::Simulation> simulation_;
  double cpuSeconds_ = 0.0;
};

using ContactMeasure = std::function<sim::Result<ContactValues>(TimedRun& run)>;

/// Runs the scene with that kind of contact and measures it. A Problem where it cannot be built or blows up.
sim::Result<ContactOutcome> measured(modeling::Scene scene, sim::ContactKind kind,
                                     const ContactMeasure& measure);

/// Height of the lowest nodes of part 1 over the highest of part 0, as a share of the smallest cell.
ContactMeasure gapAt(double until);
/// cm by which part 1 moves along x.
ContactMeasure slideUntil(double until);
/// cm by which the last part moves from half of the time on; s after which all sleeps to the end.
ContactMeasure lateSlideUntil(double until);
/// How deep either part ever gets into the other, on the shortest way out, as a share of the smallest cell,
/// in so many looks. What falls through is as deep as it was on the way.
ContactMeasure deepestUntil(double until, int looks);
/// cm by which the part that moves most is elsewhere; s after which all sleeps to the end.
ContactMeasure restUntil(double until);
/// Speed up of the last part over the speed down with which it began.
ContactMeasure reboundUntil(double until);
/// cm/s of the fastest node there ever is; how many bonds break.
ContactMeasure violenceUntil(double until);
/// Seconds to the first break, if there is one before `until`.
ContactMeasure breakBy(double until);
/// CPU seconds of the run.
ContactMeasure costUntil(double until);

}  // namespace app
