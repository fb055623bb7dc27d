#include "modeling/scene/scene_collider.h"

#include <vector>

#include "sim/collider/triangle_mesh.h"

namespace modeling {
namespace {

bool isUnread(const ColliderForm& form) {
  const auto* obstacle = std::get_if<MeshObstacle>(&form);
  return obstacle != nullptr && !obstacle->isRead();
}

/// Most kinds are simulated as they are written.
template <class Shape>
sim::ColliderShape simulated(const Shape& shape) {
  return shape;
}

sim::ColliderShape simulated(const MeshObstacle& obstacle) {
  static const auto kNothing =
      std::make_shared<const sim::TriangleMesh>(std::vector<Vec3>{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()},
                                                std::vector<sim::TriangleMesh::Triangle>{{0, 1, 2}});
  const auto& mesh = obstacle.isRead() ? obstacle.surface.mesh : kNothing;
  return sim::SurfaceShape{mesh, mesh->closed() ? 0.0 : 0.5 * obstacle.thickness};
}

}  // namespace

bool ObstacleSurface::operator==(const ObstacleSurface& other) const {
  return mesh == other.mesh || (mesh && other.mesh && *mesh == *other.mesh);
}

bool MeshObstacle::operator==(const MeshObstacle& other) const {
  const bool unread = !file.empty() && (!isRead() || !other.isRead());
  return source() == other.source() && thickness == other.thickness && (unread || surface == other.surface);
}

sim::Collider colliderOf(const SceneCollider& written) {
  sim::Collider collider;
  collider.name = written.name;
  collider.shape = std::visit([](const auto& form) { return simulated(form); }, written.form);
  collider.position = written.position;
  collider.rotation = written.rotation.quaternion();
  collider.stiffness = written.stiffness;
  collider.dampingRatio = written.dampingRatio;
  collider.friction = written.friction;
  collider.visible = written.visible;
  if (written.active) {
    collider.activeFrom = (*written.active)[0];
    collider.activeUntil = (*written.active)[1];
  }
  if (isUnread(written.form)) collider.activeUntil = collider.activeFrom;
  return collider;
}

Eigen::AlignedBox3d boxOf(const SceneCollider& collider) {
  return isUnread(collider.form) ? Eigen::AlignedBox3d() : sim::boxOf(colliderOf(collider));
}

std::string_view kindName(const ColliderForm& form) {
  return std::visit([](const auto& kind) { return std::string_view(kind.kName); }, form);
}

void scale(ColliderForm& form, const Vec3& factors) {
  std::visit([&](auto& kind) { kind.scale(factors); }, form);
}

}  // namespace modeling
