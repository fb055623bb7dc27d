#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>

#include <Eigen/Geometry>

#include "sim/base/types.h"
#include "sim/collider/triangle_mesh.h"

namespace sim {

enum class ColliderShape { floor, box, sphere, cylinder, mesh };

/// An immovable object (paper, "External forces"): pushes with k X + d V, never pulls, only while a node is
/// inside. It may be moved by tracks; nothing the network does moves it.
struct Collider {
  std::string name;
  ColliderShape shape = ColliderShape::floor;
  Vec3 position = Vec3::Zero();  ///< cm: a floor's point, else the centre
  Eigen::Quaterniond rotation =
      Eigen::Quaterniond::Identity();  ///< worldFromCollider; a floor's normal is its z
  Vec3 halfSize = Vec3::Ones();        ///< box: half edges, cm
  double radius = 1.0;                 ///< sphere, cylinder, cm
  double halfHeight = 1.0;             ///< cylinder along its z, cm
  /// In the collider's own coordinates. A closed one is solid; an open one is a sheet with two sides.
  std::shared_ptr<const TriangleMesh> mesh;
  double halfThickness = 0.0;  ///< mesh: its surface is so far out on either side, cm; > 0 for a sheet
  /// k, dyn/cm a node. Absent: the node's own contact stiffness, which never makes a break gain energy (P16).
  std::optional<double> stiffness;
  double dampingRatio = 0.3;  ///< d relative to critical, 2 sqrt(k m), of the intruding node
  double friction = 0.4;      ///< lateral force relative to k X (P10)
  bool visible = true;        ///< drawn; invisible ones still push ("invisible characters")
  double activeFrom = -std::numeric_limits<double>::infinity();  ///< s: before it does nothing at all, ...
  double activeUntil = std::numeric_limits<double>::infinity();  ///< s: ... nor from then on

  bool activeAt(double time) const { return activeFrom <= time && time < activeUntil; }
};

/// How deep a point is inside, and the way out. depth <= 0: outside, by at least -depth... the exact distance
/// for floor, sphere and mesh, a lower bound for box and cylinder.
struct Intrusion {
  double depth = 0.0;             ///< cm
  Vec3 normal = Vec3::UnitZ();    ///< unit, out of the collider
  std::uint32_t nearest = kNone;  ///< triangle of a mesh
};
/// `near`: a triangle that may be the nearest, with which it is found sooner.
Intrusion intrusion(const Collider& collider, const Vec3& point, std::uint32_t near = kNone);

/// cm: no node is let deeper than about this, however fast it comes or heavy what presses on it: well short
/// of where the way out leads to the other side. Infinite for a floor, which has no other side, and for a
/// closed mesh that is inside out.
double deepest(const Collider& collider);

}  // namespace sim
