#include <algorithm>
#include <array>
#include <cmath>

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

}  // namespace

std::optional<Vec3> TriangleMesh::crossingOf(std::uint32_t triangle) const {
  const auto cornersOf = [&](const Triangle& of) {
    return Corners{points_[of[0]], points_[of[1]], points_[of[2]]};
  };
  const Corners corners = cornersOf(triangles_[triangle]);
  const Vec3 low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]);
  const Vec3 high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
  std::array<std::uint32_t, 64> waiting{};
  std::size_t count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const Branch& branch = branches_[waiting[--count]];
    if ((branch.low.array() > high.array()).any() || (branch.high.array() < low.array()).any()) continue;
    for (std::uint32_t i = 0; i < branch.count; ++i) {
      const Triangle& other = triangles_[order_[branch.first + i]];
      if (haveCommonCorner(triangles_[triangle], other)) continue;
      if (const auto there = crossing(corners, cornersOf(other))) return there;
    }
    if (branch.count > 0) continue;
    waiting[count++] = branch.first;
    waiting[count++] = branch.first + 1;
  }
  return std::nullopt;
}

TriangleMesh::Crossings TriangleMesh::crossings() const {
  constexpr std::size_t kGrain = 256;
  std::vector<std::uint8_t> crosses(triangles_.size(), 0);
  parallelRanges(crosses.size(), kGrain, Sharing::balanced, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t)
      crosses[t] = crossingOf(static_cast<std::uint32_t>(t)).has_value() ? 1 : 0;
  });
  Crossings found;
  for (std::uint32_t t = 0; t < crosses.size(); ++t) {
    if (crosses[t] == 0) continue;
    if (found.triangles++ == 0) found.first = *crossingOf(t);
  }
  return found;
}

}  // namespace sim
