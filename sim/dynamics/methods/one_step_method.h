#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "sim/state/motion.h"
#include "sim/state/settings.h"
#include "sim/state/tangent.h"

namespace sim {

/// The right-hand side of the equations of motion at one state: x' = v, v' = a(x, v), and beside them the two
/// flows of energy that the ledger asks for, which are integrated like everything else.
struct Rates {
  NodeVectors acceleration;  ///< cm/s^2; zero for held nodes
  double dissipated = 0.0;   ///< erg/s, by dampers and friction
  double outsideWork = 0.0;  ///< erg/s, by colliders that move and held nodes that are carried along
};

/// What a method may ask of the world within a step. Nothing is remembered of what was asked; the network
/// stays as it is.
class World {
 public:
  virtual ~World() = default;
  /// At a state `ahead` seconds after the step's beginning. Colliders go on at the velocity they have.
  virtual void rates(const Motion& at, double ahead, Rates& rates) = 0;
  /// Replaces the list, at the state whose rates were last asked for: bonds in their order, then contacts.
  virtual void tangents(const Motion& at, double ahead, std::vector<Tangent>& tangents) = 0;
};

/// A method that makes a step from one moment to another, positions and velocities of the same moment. It may
/// be asked for the same step again, of another length: that is how breaks are located, so that no stage
/// mixes the network before with the one after.
class OneStepMethod {
 public:
  virtual ~OneStepMethod() = default;

  /// What flowed during a step, erg.
  struct Flow {
    double dissipated = 0.0;
    double outsideWork = 0.0;
  };
  /// `start` holds the rates at `from`. Nothing when the step is too long for the method to find its end.
  virtual std::optional<Flow> advance(World& world, const Motion& from, const Rates& start, double step,
                                      Motion& to) = 0;
  /// The error in the positions of the step just made, cm, estimated from a method of lower order or the next
  /// term of this one's own error.
  virtual void estimateError(const Motion& from, const Rates& start, double step, const Motion& to,
                             const Rates& end, NodeVectors& error) const = 0;
  /// The power of the step with which that estimate grows.
  virtual int errorPower() const = 0;
  virtual std::size_t memoryBytes() const = 0;
};

/// Null for the methods of the leapfrog family, which Stepper does by itself. The inverse masses must outlive
/// it.
std::unique_ptr<OneStepMethod> oneStepMethod(Method method, std::span<const double> inverseMasses,
                                             std::size_t nodeCount);

}  // namespace sim
