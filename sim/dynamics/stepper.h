#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "sim/base/result.h"
#include "sim/methods/integrator.h"
#include "sim/methods/step_length.h"
#include "sim/world/world.h"

namespace sim {

/// The inside of Simulation: lets the time of a World go on, step by step. What happens in a step, and in
/// which order, is makeStep().
class Stepper {
 public:
  Stepper(Network network, Environment environment, std::vector<Track> tracks, const Settings& settings);

  /// See Simulation.
  Status advanceTo(double until, const std::function<void()>& afterStep);
  Status stepOnce();
  StepLimit stepLimit() const;
  /// What touches now.
  Stiffest stiffestNow() const;
  /// About what touches where something lies in coils upon itself; nothing where that is not looked for.
  Stiffest stiffestCoil() const;
  /// s: how long the step will be at a time (s) at which no node is faster than `speed` (cm/s).
  double stepAt(double time, double speed, bool deforms, const Stiffest& touching) const;

  const World& world() const { return world_; }
  const StepLength& length() const { return length_; }
  /// For orders that come between two steps.
  World& world() { return world_; }

  /// The moment of the positions, whatever the method keeps of the velocities.
  Present present() const;
  std::vector<std::byte> checkpoint() const;
  Status restore(std::span<const std::byte> checkpoint);
  /// Goes on from where another one of an equal network is, before the first step. See
  /// Simulation::takeOver().
  void takeOver(Stepper& other);
  std::size_t memoryBytes() const;

 private:
  Status makeStep();
  void sleepUntil(double until);
  void applyTracks();
  void refreshContacts();
  void chooseStep();
  void followTolerance();
  void countWork();
  Status watchEnergy();
  void bringToPresent();
  void adoptState(const Stepper& other);

  World world_;
  StepLength length_;
  std::unique_ptr<Integrator> integrator_;
  std::optional<tbb::global_control> moreThreads_;  ///< TBB would not give more than the processor has
  mutable tbb::task_arena arena_;
};

}  // namespace sim
