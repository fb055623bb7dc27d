#include "ui/document/part_boxes.h"

namespace ui {
namespace {

using Box = Eigen::AlignedBox3d;
using modeling::Vec3;

Box shapeBox(const modeling::SlabShape& shape) {
  return {Vec3(-0.5 * shape.size.x(), -0.5 * shape.size.y(), 0.0),
          Vec3(0.5 * shape.size.x(), 0.5 * shape.size.y(), shape.size.z())};
}

Box grown(Box box, double by) {
  if (box.isEmpty()) return box;
  box.min().array() -= by;
  box.max().array() += by;
  return box;
}

/// Curves stay within the hull of their control points.
Box shapeBox(const modeling::BezierPatchShape& shape) {
  Box box;
  for (const auto& row : shape.net)
    for (const Vec3& point : row) box.extend(point);
  if (!shape.oppositeNet) return grown(box, shape.thickness);
  for (const auto& row : *shape.oppositeNet)
    for (const Vec3& point : row) box.extend(point);
  return box;
}

Box shapeBox(const modeling::RevolutionShape& shape) {
  Box box;
  for (const modeling::ProfileChain* profile : {&shape.outside, &shape.inside}) {
    for (const auto& segment : *profile)
      for (const modeling::Vec2& point : segment) {
        box.extend(Vec3(point.x(), point.x(), point.y()));
        box.extend(Vec3(-point.x(), -point.x(), point.y()));
      }
  }
  return box;
}

double largest(const modeling::ValueChain& values) {
  double result = 0.0;
  for (const auto& segment : values)
    for (const double value : segment) result = std::max(result, value);
  return result;
}

Box shapeBox(const modeling::CurvedCylinderShape& shape) {
  Box box;
  for (const modeling::CurveChain* curve : {&shape.curve, &shape.secondRail}) {
    for (const auto& segment : *curve)
      for (const Vec3& point : segment) box.extend(point);
  }
  const double width = shape.secondRail.empty() ? largest(shape.halfWidth) : 0.0;
  return grown(box, std::max(width, largest(shape.halfDepth)));
}

/// What is in a file is not known before it is read.
Box shapeBox(const modeling::NetworkShape&) {
  return {};
}

Box shapeBox(const modeling::MeshShape&) {
  return {};
}

Box transformed(const Box& box, const Eigen::Affine3d& place) {
  if (box.isEmpty()) return box;
  Box result;
  for (int corner = 0; corner < 8; ++corner)
    result.extend(place * box.corner(static_cast<Box::CornerType>(corner)));
  return result;
}

Vec3 halfSizeOf(const modeling::ColliderForm& form) {
  if (const auto* box = std::get_if<modeling::BoxShape>(&form)) return box->halfSize;
  if (const auto* sphere = std::get_if<modeling::SphereShape>(&form)) return Vec3::Constant(sphere->radius);
  const auto& cylinder = std::get<modeling::CylinderShape>(form);
  return {cylinder.radius, cylinder.radius, cylinder.halfHeight};
}

Box colliderBox(const modeling::SceneCollider& collider) {
  if (std::holds_alternative<modeling::FloorShape>(collider.form)) return {};
  if (const auto* obstacle = std::get_if<modeling::MeshObstacle>(&collider.form)) {
    if (!obstacle->surface.mesh) return {};
    return transformed(obstacle->surface.mesh->box(),
                       Eigen::Translation3d(collider.position) * collider.rotation.quaternion());
  }
  const Vec3 half = halfSizeOf(collider.form);
  return transformed(Box(-half, half),
                     Eigen::Translation3d(collider.position) * collider.rotation.quaternion());
}

}  // namespace

Box boxOf(const modeling::PartShape& shape) {
  return std::visit([](const auto& form) { return shapeBox(form); }, shape);
}

Box boxOf(const modeling::Part& part) {
  return transformed(boxOf(part.shape), part.worldFromPart.worldFromPart());
}

Box boxOf(const modeling::Scene& scene, std::span<const Item> items) {
  Box box;
  for (const Item& item : items) {
    if (item.index >= countOf(scene, item.kind)) continue;
    if (item.kind == ItemKind::part) box.extend(boxOf(scene.parts[item.index]));
    if (item.kind == ItemKind::collider) box.extend(colliderBox(scene.environment.colliders[item.index]));
  }
  return box;
}

Box boxOf(const modeling::Scene& scene) {
  Box box;
  for (const modeling::Part& part : scene.parts) box.extend(boxOf(part));
  for (const modeling::SceneCollider& collider : scene.environment.colliders)
    box.extend(colliderBox(collider));
  return box;
}

}  // namespace ui
