#include "sim/contact/collider.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {

Intrusion inBox(const Vec3& halfSize, const Vec3& local) {
  const Vec3 depths = halfSize - local.cwiseAbs();
  Eigen::Index axis = 0;
  const double depth = depths.minCoeff(&axis);
  Vec3 normal = Vec3::Zero();
  normal[axis] = local[axis] < 0.0 ? -1.0 : 1.0;
  return {depth, normal};
}

Intrusion inSphere(double radius, const Vec3& local) {
  const double distance = local.norm();
  const Vec3 normal = distance > 0.0 ? Vec3(local / distance) : Vec3(Vec3::UnitZ());
  return {radius - distance, normal};
}

Intrusion inCylinder(double radius, double halfHeight, const Vec3& local) {
  const double distance = std::hypot(local.x(), local.y());
  const double side = radius - distance;
  const double end = halfHeight - std::abs(local.z());
  if (end < side) return {end, Vec3(0.0, 0.0, local.z() < 0.0 ? -1.0 : 1.0)};
  if (distance > 0.0) return {side, Vec3(local.x() / distance, local.y() / distance, 0.0)};
  return {side, Vec3::UnitX()};
}

/// By distance, so that edges and corners are round where a sheet's thickness goes round them: nothing leaks
/// in between two triangles. Straight through is what is nearest, whichever side of a sheet it came from.
Intrusion inMesh(const TriangleMesh& mesh, double halfThickness, const Vec3& local) {
  const TriangleMesh::Nearest there = mesh.nearest(local);
  const Vec3 away = local - there.point;
  const bool inside = mesh.closed() && away.dot(there.normal) < 0.0;
  const double distance = inside ? -there.distance : there.distance;
  const Vec3 normal = there.distance > 0.0 ? Vec3(away / distance) : there.normal;
  return {halfThickness - distance, normal};
}

}  // namespace

Intrusion intrusion(const Collider& collider, const Vec3& point) {
  const Vec3 local = collider.rotation.conjugate() * (point - collider.position);
  Intrusion inside;
  switch (collider.shape) {
    case ColliderShape::floor:
      inside = {-local.z(), Vec3::UnitZ()};
      break;
    case ColliderShape::box:
      inside = inBox(collider.halfSize, local);
      break;
    case ColliderShape::sphere:
      inside = inSphere(collider.radius, local);
      break;
    case ColliderShape::cylinder:
      inside = inCylinder(collider.radius, collider.halfHeight, local);
      break;
    case ColliderShape::mesh:
      inside = inMesh(*collider.mesh, collider.halfThickness, local);
      break;
  }
  inside.normal = collider.rotation * inside.normal;
  return inside;
}

}  // namespace sim
