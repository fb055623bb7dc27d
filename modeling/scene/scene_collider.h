#pragma once

#include <array>
#include <concepts>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "modeling/scene/placement.h"
#include "modeling/shapes/mesh_shape.h"
#include "sim/collider/collider.h"

namespace modeling {

using sim::BoxShape;
using sim::CylinderShape;
using sim::FloorShape;
using sim::SphereShape;

/// The triangles of an obstacle, shared by all copies of the scene; null: not read yet.
struct ObstacleSurface {
  std::shared_ptr<const sim::TriangleMesh> mesh;

  bool operator==(const ObstacleSurface& other) const;
};

/// A mesh that things collide with. One of `file` and `surface` is given; build() reads the file where there
/// is no surface, and what a take is headed by has the surface, so that it can be resumed anywhere.
struct MeshObstacle {
  static constexpr std::string_view kName = sim::SurfaceShape::kName;

  std::string file;  ///< see MeshSource
  MeshUnit unit = MeshUnit::guess;
  MeshUp up = MeshUp::guess;
  double thickness = 0.4;   ///< of a sheet, which an open mesh is, cm; a closed one is solid
  ObstacleSurface surface;  ///< in the collider's coordinates, cm

  MeshSource source() const { return {file, unit, up}; }
  bool isRead() const { return surface.mesh != nullptr; }
  /// Nothing: its size is the file's.
  void scale(const Vec3&) {}
  /// A surface that was not read yet is that of the same file.
  bool operator==(const MeshObstacle& other) const;
};

/// How a kind of collider stands in a scene: as it is simulated, but for triangles, which a scene takes from
/// a file.
template <class Shape>
struct WrittenForm {
  using Form = Shape;
};
template <>
struct WrittenForm<sim::SurfaceShape> {
  using Form = MeshObstacle;
};
template <class... Shapes>
struct WrittenForm<std::variant<Shapes...>> {
  using Form = std::variant<typename WrittenForm<Shapes>::Form...>;
};
/// All kinds that are simulated, in their order (sim/collider/collider.h).
using ColliderForm = WrittenForm<sim::ColliderShape>::Form;

/// What each kind says of itself.
template <class Form>
concept ColliderFormKind = std::equality_comparable<Form> && std::default_initializable<Form> &&
    requires(Form& form, const Vec3& factors) {
  /// As files call it.
  { Form::kName } -> std::convertible_to<std::string_view>;
  /// Makes it larger by a factor along each of its axes, as far as it can be.
  { form.scale(factors) } -> std::same_as<void>;
};

template <class Variant>
inline constexpr bool kAllAreColliderForms = false;
template <class... Forms>
inline constexpr bool kAllAreColliderForms<std::variant<Forms...>> = (ColliderFormKind<Forms> && ...);
static_assert(kAllAreColliderForms<ColliderForm>, "a kind of collider leaves something out");

/// See sim::Collider.
struct SceneCollider {
  std::string name;
  ColliderForm form;
  Vec3 position = Vec3::Zero();
  Rotation rotation;
  std::optional<double> stiffness;  ///< dyn/cm a node; absent: the node's own
  double dampingRatio = sim::Collider{}.dampingRatio;
  double friction = sim::Collider{}.friction;
  bool visible = true;
  std::optional<std::array<double, 2>> active;  ///< s, from and until, the end excluded; absent: always

  /// Whether it goes on without an end.
  bool isFloor() const { return std::holds_alternative<FloorShape>(form); }
  bool operator==(const SceneCollider&) const = default;
};

/// Where it stands without tracks. An obstacle whose surface was not read is there, but never active.
sim::Collider colliderOf(const SceneCollider& written);
/// Contains it, in the world. Empty for a floor and for an obstacle whose surface was not read.
Eigen::AlignedBox3d boxOf(const SceneCollider& collider);

/// As files call its kind.
std::string_view kindName(const ColliderForm& form);
/// Makes it larger by a factor along each of its axes, as far as it can be: a sphere stays a sphere.
void scale(ColliderForm& form, const Vec3& factors);

}  // namespace modeling
