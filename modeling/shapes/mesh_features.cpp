#include "modeling/shapes/mesh_features.h"

#include <cmath>
#include <map>
#include <numbers>

namespace modeling {

using sim::TriangleMesh;
using sim::Vec3;

MeshFeatures::MeshFeatures(const TriangleMesh& mesh) {
  static const double kCosine = std::cos(kSharpAngle * std::numbers::pi / 180.0);
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3> normals;  // of the first face at an edge
  std::map<std::uint32_t, std::vector<Vec3>> ways;                  // sharp edges that leave a point
  std::vector<Vec3> points;
  std::vector<TriangleMesh::Triangle> slivers;
  for (const auto& triangle : mesh.triangles()) {
    const Vec3& a = mesh.points()[triangle[0]];
    const Vec3 normal =
        (mesh.points()[triangle[1]] - a).cross(mesh.points()[triangle[2]] - a).stableNormalized();
    for (std::size_t c = 0; c < 3; ++c) {
      const auto ends = std::minmax(triangle[c], triangle[(c + 1) % 3]);
      const auto [other, isFirst] = normals.try_emplace({ends.first, ends.second}, normal);
      if (isFirst || other->second.dot(normal) > kCosine) continue;
      const Vec3& from = mesh.points()[ends.first];
      const Vec3& to = mesh.points()[ends.second];
      const auto first = static_cast<std::uint32_t>(points.size());
      points.insert(points.end(), {from, to, to});
      slivers.push_back({first, first + 1, first + 2});
      ways[ends.first].push_back((to - from).stableNormalized());
      ways[ends.second].push_back((from - to).stableNormalized());
    }
  }
  for (const auto& [point, out] : ways) {
    const bool passes = out.size() == 2 && out[0].dot(out[1]) < -kCosine;
    if (!passes) corners_.push_back(mesh.points()[point]);
  }
  if (!slivers.empty()) edges_.emplace(std::move(points), slivers);
}

}  // namespace modeling
