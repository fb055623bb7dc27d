#include "tests/support/meshes.h"

#include <cmath>
#include <numbers>

namespace tests {

using sim::TriangleMesh;
using sim::Vec3;

TriangleMesh boxMesh(const Vec3& halfSize) {
  std::vector<Vec3> points;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 signs((corner & 1U) ? 1.0 : -1.0, (corner & 2U) ? 1.0 : -1.0, (corner & 4U) ? 1.0 : -1.0);
    points.emplace_back(signs.cwiseProduct(halfSize));
  }
  const std::vector<TriangleMesh::Triangle> triangles{{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6},
                                                      {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                                      {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return {points, triangles};
}

TriangleMesh ballMesh(double radius, unsigned rings) {
  const unsigned around = 2 * rings;
  std::vector<Vec3> points{Vec3(0.0, 0.0, -radius)};
  for (unsigned ring = 1; ring < rings; ++ring) {
    const double polar = std::numbers::pi * ring / rings;
    for (unsigned i = 0; i < around; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / around;
      points.emplace_back(radius * Vec3(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle),
                                        -std::cos(polar)));
    }
  }
  points.emplace_back(0.0, 0.0, radius);
  const auto top = static_cast<std::uint32_t>(points.size() - 1);
  const auto at = [&](unsigned ring, unsigned i) { return 1 + (ring - 1) * around + i % around; };
  std::vector<TriangleMesh::Triangle> triangles;
  for (unsigned i = 0; i < around; ++i) {
    triangles.push_back({0, at(1, i + 1), at(1, i)});
    triangles.push_back({top, at(rings - 1, i), at(rings - 1, i + 1)});
    for (unsigned ring = 1; ring + 1 < rings; ++ring) {
      triangles.push_back({at(ring, i), at(ring, i + 1), at(ring + 1, i + 1)});
      triangles.push_back({at(ring, i), at(ring + 1, i + 1), at(ring + 1, i)});
    }
  }
  return {points, triangles};
}

TriangleMesh sheetMesh(double halfSize) {
  const double h = halfSize;
  return {{Vec3(-h, -h, 0.0), Vec3(h, -h, 0.0), Vec3(h, h, 0.0), Vec3(-h, h, 0.0)}, {{0, 1, 2}, {0, 2, 3}}};
}

}  // namespace tests
