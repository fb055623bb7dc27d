#pragma once

#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "sim/base/bytes.h"
#include "sim/dynamics/motion.h"
#include "sim/network/network.h"

namespace sim {

/// A fragment that flies freely and has no strain to speak of, moved as one rigid body (B4). It keeps the
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
  const Vec3& centre() const { return centre_; }
  const Vec3& velocity() const { return velocity_; }  ///< of the centre, cm/s
  /// rad/s, now.
  Vec3 angularVelocity() const;
  /// No node is faster, cm/s.
  double fastest() const;
  /// Energy of motion, erg.
  double kineticEnergy() const;
  /// What a node's velocity has beside the rigid motion, cm/s.
  Vec3 vibration(std::size_t index, const Vec3& velocity) const;

  void kick(const Vec3& change) { velocity_ += change; }
  /// Moves on by `step` seconds, the centre by `velocity` (cm/s).
  void drift(double step, const Vec3& velocity);

  /// Where the nodes are.
  void place(NodeVectors& positions) const;
  /// How the nodes move, with `more` (cm/s) added to all.
  void placeVelocities(NodeVectors& velocities, const Vec3& more = Vec3::Zero()) const;

  void save(ByteWriter& writer) const;
  bool load(ByteReader& reader, std::size_t nodeCount);
  std::size_t memoryBytes() const;

 private:
  Vec3 arm(std::size_t index) const { return worldFromBody_ * shape_[index]; }
  Vec3 angularVelocityAt(const Eigen::Quaterniond& worldFromBody) const;

  FragmentId fragment_ = kNone;
  std::vector<NodeIndex> nodes_;
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
