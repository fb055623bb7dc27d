#pragma once

#include <limits>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "sim/base/bytes.h"
#include "sim/network/network.h"
#include "sim/state/motion.h"

namespace sim {

/// A fragment that flies freely and has no strain to speak of, moved as one rigid body. It keeps the
/// shape it has, and its momentum and angular momentum to rounding; its vibration is dropped.
///
/// The centre moves by the method's own recurrence, so that under gravity it goes exactly where the nodes
/// would have taken it. The rotation solves L = const with the midpoint rule, error (angle a step)^3.
/// Velocities belong to the same moment as those of Motion: half a step behind the positions for velocity
/// Verlet.
class RigidBody {
 public:
  RigidBody() = default;
  /// Takes the nodes as they stand and move. All must have finite mass.
  RigidBody(const Network& network, FragmentId fragment, std::span<const NodeIndex> nodes,
            const Motion& motion);

  FragmentId fragment() const { return fragment_; }
  std::span<const NodeIndex> nodes() const { return nodes_; }
  double mass() const { return mass_; }
  /// From the centre to the furthest node, cm.
  double radius() const { return radius_; }
  const Vec3& centre() const { return centre_; }
  const Vec3& velocity() const { return velocity_; }                ///< of the centre, cm/s
  const Vec3& angularMomentum() const { return angularMomentum_; }  ///< about the centre, g cm^2/s
  Vec3 velocityAt(const Vec3& point) const { return velocity_ + angularVelocity().cross(point - centre_); }
  /// rad/s, now.
  Vec3 angularVelocity() const;
  /// No node is faster, cm/s.
  double fastest() const;
  /// Energy of motion, erg.
  double kineticEnergy() const;
  /// From the centre to a node, by its place in nodes(), cm.
  Vec3 arm(std::size_t index) const { return worldFromBody_ * shape_[index]; }

  /// Velocity of the centre (cm/s) and angular velocity (rad/s).
  struct Rates {
    Vec3 velocity, spin;
    Vec3 at(const Vec3& arm) const { return velocity + spin.cross(arm); }
  };
  Rates rates() const { return {velocity_, angularVelocity()}; }
  /// As they would be with so much more velocity, and an impulse of torque (g cm^2/s).
  Rates ratesAfter(const Vec3& change, const Vec3& torqueImpulse) const;

  /// No contact may near faster than this, or it must deform, cm/s.
  double gentleSpeed() const { return gentleSpeed_; }
  void setGentleSpeed(double speed) { gentleSpeed_ = speed; }
  /// What loads do to it, which it does not show by deforming. A load is the sum of each push times its arm
  /// from the centre (erg), the mean stress times the volume where pushes are in balance.
  struct Bearing {
    double most = std::numeric_limits<double>::infinity();  ///< erg: more than this and it must deform
    double time = 0.0;                                      ///< s: so long must a load last to bend it
  };
  void setBearing(const Bearing& bearing) { bearing_ = bearing; }
  /// A load for so many seconds. False when the body must deform: it is more than it bears beside its own
  /// weight under this gravity (cm/s^2) and the load with which it became rigid, which is all that strained
  /// it.
  bool bears(double load, double seconds, double gravity);
  /// Places in nodes() of those that contacts may push, ascending.
  const std::vector<std::uint32_t>& touched() const { return touched_; }
  void setTouched(std::vector<std::uint32_t> places) { touched_ = std::move(places); }
  /// What a node's velocity has beside the rigid motion, cm/s.
  Vec3 vibration(std::size_t index, const Vec3& velocity) const;

  void kick(const Vec3& change) { velocity_ += change; }
  void kick(const Vec3& change, const Vec3& torqueImpulse) {
    velocity_ += change;
    angularMomentum_ += torqueImpulse;
  }
  /// Moves on by `step` seconds, the centre by `velocity` (cm/s).
  void drift(double step, const Vec3& velocity);

  /// Where the nodes are.
  void place(NodeVectors& positions) const;
  void placeVelocities(NodeVectors& velocities) const { placeVelocities(velocities, rates()); }
  void placeVelocities(NodeVectors& velocities, const Rates& rates) const;
  /// Both, of the touched nodes only.
  void placeTouched(Motion& motion) const;

  void save(ByteWriter& writer) const;
  bool load(ByteReader& reader, std::size_t nodeCount);
  std::size_t memoryBytes() const;

 private:
  Vec3 angularVelocityAt(const Eigen::Quaterniond& worldFromBody, const Vec3& angularMomentum) const;

  FragmentId fragment_ = kNone;
  std::vector<NodeIndex> nodes_;
  std::vector<std::uint32_t> touched_;
  double gentleSpeed_ = 0.0;
  Bearing bearing_;
  double load_ = 0.0;        ///< erg: mean of late
  double firstLoad_ = -1.0;  ///< erg; below zero: none was seen yet
  std::vector<Vec3> shape_;  ///< from the centre, in the axes of inertia, cm
  double mass_ = 0.0;
  double radius_ = 0.0;                  ///< of the furthest node, cm
  Vec3 inverseInertia_ = Vec3::Zero();   ///< about the axes, 1/(g cm^2); zero where there is no extent
  Vec3 centre_ = Vec3::Zero();           ///< cm
  Vec3 velocity_ = Vec3::Zero();         ///< cm/s
  Vec3 angularMomentum_ = Vec3::Zero();  ///< about the centre, g cm^2/s
  Eigen::Quaterniond worldFromBody_ = Eigen::Quaterniond::Identity();
};

}  // namespace sim
