#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "modeling/scene/placement.h"
#include "modeling/shapes/bezier_patch.h"
#include "modeling/shapes/curved_cylinder.h"
#include "modeling/shapes/mesh_shape.h"
#include "modeling/shapes/network_shape.h"
#include "modeling/shapes/revolution.h"
#include "modeling/shapes/slab.h"

namespace modeling {

/// The kinds of parts. Each has a header of its own with all that is known of it (PartKind).
using PartShape =
    std::variant<SlabShape, BezierPatchShape, RevolutionShape, CurvedCylinderShape, NetworkShape, MeshShape>;

/// What each kind says of itself, in the part's own coordinates (cm). What it is made into is up to
/// PartBuilder (build_parts.cpp): mostly build(shape), a lattice.
template <class Shape>
concept PartKind = std::equality_comparable<Shape> && std::default_initializable<Shape> &&
    requires(const Shape& shape) {
  /// As files call it.
  { Shape::kName } -> std::convertible_to<std::string_view>;
  /// Contains it, though not as tightly as can be; empty where only a file says where it is.
  { shape.box() } -> std::same_as<Eigen::AlignedBox3d>;
  /// The edge that its cells are to have, > 0; nothing where it has no cells.
  { shape.cellEdge() } -> std::same_as<std::optional<double>>;
};

template <class Variant>
inline constexpr bool kAllArePartKinds = false;
template <class... Shapes>
inline constexpr bool kAllArePartKinds<std::variant<Shapes...>> = (PartKind<Shapes> && ...);
static_assert(kAllArePartKinds<PartShape>, "a kind of part leaves something out");

struct Part {
  std::string name;
  PartShape shape;
  std::string material;  ///< a material's name; a network may leave it out
  Placement worldFromPart;
  Vec3 velocity = Vec3::Zero();         ///< cm/s
  Vec3 angularVelocity = Vec3::Zero();  ///< rad/s, about its centre of mass
  std::vector<Box> hold;                ///< part coordinates: nodes inside are held where they are

  bool operator==(const Part&) const = default;
};

/// As files call its kind.
std::string_view kindName(const PartShape& shape);
/// Contains the shape, in the part's own coordinates. Told from outlines alone, so that it is at once there,
/// while a lattice has to be built first; empty where only a file says where it is.
Eigen::AlignedBox3d boxOf(const PartShape& shape);
/// Contains the part, in the world.
Eigen::AlignedBox3d boxOf(const Part& part);
/// The edge that its cells are to have, cm; nothing where it has no cells.
std::optional<double> cellEdgeOf(const PartShape& shape);

}  // namespace modeling
