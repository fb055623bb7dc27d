#include "sim/collider/surface_shape.h"

#include <limits>

#include "sim/collider/triangle_mesh.h"

namespace sim {

Intrusion SurfaceShape::intrusion(const Vec3& local, std::uint32_t near) const {
  const TriangleMesh::Nearest there = mesh->nearest(local, near);
  const Vec3 away = local - there.point;
  const bool inside = mesh->closed() && away.dot(there.normal) < 0.0;
  const double distance = inside ? -there.distance : there.distance;
  const Vec3 normal = there.distance > 0.0 ? Vec3(away / distance) : there.normal;
  return {halfThickness - distance, normal, there.triangle};
}

double SurfaceShape::middleDepth() const {
  const double half = halfThickness + 0.5 * mesh->leastThickness();
  return half > 0.0 ? half : std::numeric_limits<double>::infinity();
}

double SurfaceShape::reach() const {
  const Eigen::AlignedBox3d box = mesh->box();
  return box.min().cwiseAbs().cwiseMax(box.max().cwiseAbs()).norm() + halfThickness;
}

ColliderSurface SurfaceShape::surface() const {
  ColliderSurface surface;
  for (const TriangleMesh::Triangle& triangle : mesh->triangles()) {
    const auto first = static_cast<std::uint32_t>(surface.points.size());
    const Vec3& a = mesh->points()[triangle[0]];
    const Vec3& b = mesh->points()[triangle[1]];
    const Vec3& c = mesh->points()[triangle[2]];
    const Vec3 normal = (b - a).cross(c - a).stableNormalized();
    for (const Vec3& corner : {a, b, c}) surface.addPoint(corner, normal);
    surface.quads.push_back({first, first + 1, first + 2, first + 2});
  }
  return surface;
}

ColliderOutline SurfaceShape::outline() const {
  ColliderOutline outline;
  for (const TriangleMesh::Triangle& triangle : mesh->triangles()) {
    for (std::size_t c = 0; c < 3; ++c) {
      // The two triangles of an edge run along it in opposite directions.
      const std::uint32_t from = triangle[c];
      const std::uint32_t to = triangle[(c + 1) % 3];
      if (from < to) outline.push_back({mesh->points()[from], mesh->points()[to]});
    }
  }
  return outline;
}

bool SurfaceShape::operator==(const SurfaceShape& other) const {
  return halfThickness == other.halfThickness && (mesh == other.mesh || *mesh == *other.mesh);
}

}  // namespace sim
