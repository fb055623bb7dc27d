#include "sim/collider/collider.h"

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

/// Of the depth at which the way out may lead to another side. With the hops in which ways are looked at
/// (collider_stop.cpp) no node gets to nine tenths of it.
constexpr double kDeepestShare = 0.8;

/// By distance, so that edges and corners are round where a sheet's thickness goes round them: nothing leaks
/// in between two triangles. Straight through is what is nearest, whichever side of a sheet it came from.
Intrusion inMesh(const TriangleMesh& mesh, double halfThickness, const Vec3& local, std::uint32_t near) {
  const TriangleMesh::Nearest there = mesh.nearest(local, near);
  const Vec3 away = local - there.point;
  const bool inside = mesh.closed() && away.dot(there.normal) < 0.0;
  const double distance = inside ? -there.distance : there.distance;
  const Vec3 normal = there.distance > 0.0 ? Vec3(away / distance) : there.normal;
  return {halfThickness - distance, normal, there.triangle};
}

}  // namespace

Intrusion intrusion(const Collider& collider, const Vec3& point, std::uint32_t near) {
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
      inside = inMesh(*collider.mesh, collider.halfThickness, local, near);
      break;
  }
  inside.normal = collider.rotation * inside.normal;
  return inside;
}

double deepest(const Collider& collider) {
  switch (collider.shape) {
    case ColliderShape::floor:
      break;
    case ColliderShape::box:
      return kDeepestShare * collider.halfSize.minCoeff();
    case ColliderShape::sphere:
      return kDeepestShare * collider.radius;
    case ColliderShape::cylinder:
      return kDeepestShare * std::min(collider.radius, collider.halfHeight);
    case ColliderShape::mesh:
      if (const double half = collider.halfThickness + 0.5 * collider.mesh->leastThickness(); half > 0.0)
        return kDeepestShare * half;
      break;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace sim
