#pragma once

#include "sim/base/result.h"
#include "sim/passes/breaking.h"
#include "sim/world/account.h"

namespace sim {

class StepLength;

/// A method of integration: how the nodes of a World go from one moment to the next. There is one for each
/// entry of the table of methods (method_table.h).
class Integrator {
 public:
  virtual ~Integrator() = default;

  /// Makes one step of the World's clock: moves world.now on, and leaves the state before in world.next.
  /// Gives how far a node went at most, cm. A Problem when the motion blows up. The clock does not tick.
  virtual Result<double> advance(World& world, StepLength& length) = 0;

  /// s: how long the forces of the coming step act on the velocities.
  virtual double kick(const Clock& clock) const { return clock.wanted; }
  /// The wanted step becomes the step at once. Else the method makes steps as it comes to them, and may
  /// shorten them.
  virtual bool stepsAsWanted() const { return true; }
  /// The state in which bonds break after a step, and when that was.
  virtual BreakingMoment breakingMoment(const World& world) const = 0;

  /// What velocities and flows are at the moment of the positions. Changes nothing, so that looking never
  /// changes the motion.
  virtual Present present(const World& world) const;
  /// The account at a moment, and the mechanical energy that the method keeps then, erg.
  struct Kept {
    LedgerRow row;
    double energy = 0.0;
  };
  virtual Kept keptEnergy(const World& world) const;
  /// Forces are about to leap: brings velocities to the moment of the positions, by the forces there were.
  virtual void finishKick(World&) {}
  /// Gravity has changed from this: the part of a kick that is still to come is one by the gravity of before.
  virtual void shiftKick(World&, const Vec3& /*gravityBefore*/) {}
  /// What it may remember of the forces on world.now is no longer true.
  virtual void forgetForces() {}

  virtual std::size_t memoryBytes() const = 0;
};

}  // namespace sim
