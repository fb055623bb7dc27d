#pragma once

#include <optional>
#include <vector>

#include "sim/methods/rates.h"
#include "sim/state/motion.h"
#include "sim/state/tangent.h"

namespace sim {

/// The right-hand side of the equations of motion, as a scheme may ask for it within a step. Nothing is
/// remembered of what was asked; the network stays as it is.
class RightHandSide {
 public:
  virtual ~RightHandSide() = default;
  /// At a state `ahead` seconds after the step's beginning. Colliders go on at the velocity they have.
  virtual void rates(const Motion& at, double ahead, Rates& rates) = 0;
  /// Replaces the list, at the state whose rates were last asked for: bonds in their order, then contacts.
  virtual void tangents(const Motion& at, double ahead, std::vector<Tangent>& tangents) = 0;
};

/// The formula of a method that makes a step from one moment to another, positions and velocities of the same
/// moment. It may be asked for the same step again, of another length: that is how breaks are located, so
/// that no stage mixes the network before with the one after.
class OneStepScheme {
 public:
  virtual ~OneStepScheme() = default;

  /// What flowed during a step, erg.
  struct Flow {
    double dissipated = 0.0;
    double outsideWork = 0.0;
  };
  /// `start` holds the rates at `from`. Nothing when the step (s) is too long for the scheme to find its end.
  virtual std::optional<Flow> advance(RightHandSide& world, const Motion& from, const Rates& start,
                                      double step, Motion& to) = 0;
  /// The error in the positions of the step just made, cm, estimated from a method of lower order or the next
  /// term of this one's own error. It grows with the power of the step that ErrorRule names.
  virtual void estimateError(const Motion& from, const Rates& start, double step, const Motion& to,
                             const Rates& end, NodeVectors& error) const = 0;
  virtual std::size_t memoryBytes() const = 0;
};

}  // namespace sim
