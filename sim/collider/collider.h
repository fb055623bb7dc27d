#pragma once

#include <concepts>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include <Eigen/Geometry>

#include "sim/base/types.h"
#include "sim/collider/box_shape.h"
#include "sim/collider/cylinder_shape.h"
#include "sim/collider/floor_shape.h"
#include "sim/collider/sphere_shape.h"
#include "sim/collider/surface_shape.h"

namespace sim {

/// The kinds of colliders. Each has a header of its own with all that is known of it (ColliderKind).
using ColliderShape = std::variant<FloorShape, BoxShape, SphereShape, CylinderShape, SurfaceShape>;

/// What each kind says of itself, in the collider's own coordinates (cm).
template <class Shape>
concept ColliderKind = std::equality_comparable<Shape> &&
    requires(const Shape& shape, const Vec3& local, std::uint32_t near) {
  /// As files call it.
  { Shape::kName } -> std::convertible_to<std::string_view>;
  /// How deep a point is inside.
  { shape.intrusion(local, near) } -> std::same_as<Intrusion>;
  /// The least depth at which the way out may lead to another side; infinite where there is none.
  { shape.middleDepth() } -> std::same_as<double>;
  /// Distance of the furthest point from the origin.
  { shape.reach() } -> std::same_as<double>;
  /// How it is drawn.
  { shape.surface() } -> std::same_as<ColliderSurface>;
  { shape.outline() } -> std::same_as<ColliderOutline>;
};

template <class Variant>
inline constexpr bool kAllAreColliderKinds = false;
template <class... Shapes>
inline constexpr bool kAllAreColliderKinds<std::variant<Shapes...>> = (ColliderKind<Shapes> && ...);
static_assert(kAllAreColliderKinds<ColliderShape>, "a kind of collider leaves something out");

/// An immovable object (paper, "External forces"): pushes with k X + d V, never pulls, only while a node is
/// inside. It may be moved by tracks; nothing the network does moves it.
struct Collider {
  std::string name;
  ColliderShape shape;
  Vec3 position = Vec3::Zero();                                  ///< cm: of the origin of its own coordinates
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< worldFromCollider
  /// k, dyn/cm a node. Absent: the node's own contact stiffness, which never makes a break gain energy.
  std::optional<double> stiffness;
  double dampingRatio = 0.3;  ///< d relative to critical, 2 sqrt(k m), of the intruding node
  double friction = 0.4;      ///< lateral force relative to k X
  bool visible = true;        ///< drawn; invisible ones still push ("invisible characters")
  double activeFrom = -std::numeric_limits<double>::infinity();  ///< s: before it does nothing at all, ...
  double activeUntil = std::numeric_limits<double>::infinity();  ///< s: ... nor from then on

  bool activeAt(double time) const { return activeFrom <= time && time < activeUntil; }
  /// Whether it goes on without an end.
  bool isFloor() const { return std::holds_alternative<FloorShape>(shape); }
};

/// How deep a point of the world is inside. `near`: a triangle that may be the nearest, from which it is
/// found sooner.
Intrusion intrusion(const Collider& collider, const Vec3& point, std::uint32_t near = kNone);

/// cm: no node is let deeper than about this, however fast it comes or heavy what presses on it: well short
/// of where the way out leads to the other side. Infinite for a floor, which has no other side, and for a
/// closed mesh that is inside out.
double deepest(const Collider& collider);

/// Distance of the furthest point of its surface from its origin, cm. The largest number for a floor.
double reachOf(const Collider& collider);

/// As files call its kind.
std::string_view kindName(const Collider& collider);

/// How it is drawn, in its own coordinates.
ColliderSurface surfaceOf(const Collider& collider);
/// Lines that show its form, in the world.
ColliderOutline outlineOf(const Collider& collider);
/// Holds the outline, in the world. Empty for a floor.
Eigen::AlignedBox3d boxOf(const Collider& collider);

}  // namespace sim
