#include "sim/collider/mesh_crossings.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "sim/base/parallel.h"
#include "sim/collider/triangle_mesh.h"

namespace sim {
namespace {

using Corners = std::array<Vec3, 3>;

/// Six times the volume of a tetrahedron.
double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

/// Where the segment passes through the triangle, not along it nor past its edges.
std::optional<Vec3> passage(const Vec3& from, const Vec3& to, const Corners& corners) {
  const auto& [a, b, c] = corners;
  const double low = volume(a, b, c, from);
  const double high = volume(a, b, c, to);
  if (!(low * high < 0.0)) return std::nullopt;
  const double ab = volume(from, to, a, b);
  const double bc = volume(from, to, b, c);
  const double ca = volume(from, to, c, a);
  const bool within = (ab > 0.0 && bc > 0.0 && ca > 0.0) || (ab < 0.0 && bc < 0.0 && ca < 0.0);
  if (!within) return std::nullopt;
  return Vec3(from + low / (low - high) * (to - from));
}

std::optional<Vec3> crossing(const Corners& left, const Corners& right) {
  for (std::size_t c = 0; c < 3; ++c) {
    if (const auto there = passage(left[c], left[(c + 1) % 3], right)) return there;
    if (const auto there = passage(right[c], right[(c + 1) % 3], left)) return there;
  }
  return std::nullopt;
}

bool haveCommonCorner(const TriangleMesh::Triangle& left, const TriangleMesh::Triangle& right) {
  return std::any_of(left.begin(), left.end(), [&](std::uint32_t point) {
    return std::find(right.begin(), right.end(), point) != right.end();
  });
}

Corners cornersOf(const TriangleMesh& mesh, std::uint32_t triangle) {
  const TriangleMesh::Triangle& points = mesh.triangles()[triangle];
  return {mesh.points()[points[0]], mesh.points()[points[1]], mesh.points()[points[2]]};
}

/// Where another triangle passes through this one, or the other way round.
std::optional<Vec3> crossingOf(const TriangleMesh& mesh, std::uint32_t triangle) {
  const Corners corners = cornersOf(mesh, triangle);
  const Vec3 low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
  const Vec3 high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
  std::optional<Vec3> there;
  mesh.anyWithin(low, high, [&](std::uint32_t other) {
    if (haveCommonCorner(mesh.triangles()[triangle], mesh.triangles()[other])) return false;
    there = crossing(corners, cornersOf(mesh, other));
    return there.has_value();
  });
  return there;
}

}  // namespace

MeshCrossings crossingsOf(const TriangleMesh& mesh) {
  constexpr std::size_t kGrain = 256;
  std::vector<std::uint8_t> crosses(mesh.triangles().size(), 0);
  parallelRanges(crosses.size(), kGrain, Sharing::balanced, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      crosses[t] = crossingOf(mesh, static_cast<std::uint32_t>(t)).has_value() ? 1 : 0;
  });
  MeshCrossings found;
  for (std::uint32_t t = 0; t < crosses.size(); ++t) {
    if (crosses[t] == 0) continue;
    if (found.triangles++ == 0) found.first = *crossingOf(mesh, t);
  }
  return found;
}

}  // namespace sim
