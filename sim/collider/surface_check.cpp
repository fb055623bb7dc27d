#include "sim/collider/surface_check.h"

#include <algorithm>
#include <cstdio>

namespace sim {
namespace {

/// A doubled area below this share of the square of its longest edge is rounding.
constexpr double kLeastArea = 1e-12;
/// As many corners may be strays: one, or one in a thousand.
constexpr std::size_t kCornersAStray = 1000;
/// Fewer corners have no middle that a stray could be far from.
constexpr std::size_t kFewCorners = 4;

std::string placeText(const Vec3& point) {
  char text[96];
  std::snprintf(text, sizeof text, "(%.4g, %.4g, %.4g)", point.x(), point.y(), point.z());
  return text;
}

bool hasArea(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return (b - a).cross(c - a).norm() > kLeastArea * longest;
}

std::vector<Vec3> usedPoints(const std::vector<Vec3>& points,
                             const std::vector<TriangleMesh::Triangle>& triangles) {
  std::vector<std::uint8_t> isUsed(points.size(), 0);
  for (const auto& triangle : triangles)
    for (const std::uint32_t point : triangle) isUsed[point] = 1;
  std::vector<Vec3> used;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (isUsed[i] != 0) used.push_back(points[i]);
  return used;
}

Vec3 medianOf(const std::vector<Vec3>& points) {
  Vec3 median;
  std::vector<double> along(points.size());
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    std::transform(points.begin(), points.end(), along.begin(), [&](const Vec3& p) { return p[axis]; });
    const auto middle = along.begin() + static_cast<std::ptrdiff_t>(along.size() / 2);
    std::nth_element(along.begin(), middle, along.end());
    median[axis] = *middle;
  }
  return median;
}

/// Of the corners, the one that is far from all others; null: none is.
const Vec3* strayOf(std::vector<Vec3>& points) {
  std::sort(points.begin(), points.end(), [](const Vec3& left, const Vec3& right) {
    return std::lexicographical_compare(left.data(), left.data() + 3, right.data(), right.data() + 3);
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < kFewCorners) return nullptr;
  const Vec3 median = medianOf(points);
  std::sort(points.begin(), points.end(), [&](const Vec3& left, const Vec3& right) {
    return (left - median).squaredNorm() < (right - median).squaredNorm();
  });
  const std::size_t strays = std::max<std::size_t>(1, points.size() / kCornersAStray);
  for (std::size_t i = points.size() - strays; i < points.size(); ++i) {
    if ((points[i] - median).norm() > kStrayRatio * (points[i - 1] - median).norm()) return &points[i];
  }
  return nullptr;
}

}  // namespace

Status checkSurface(const std::vector<Vec3>& points, const std::vector<TriangleMesh::Triangle>& triangles) {
  if (triangles.empty()) return Problem{"", "there are no triangles in this mesh", "export a mesh of faces"};
  std::vector<Vec3> used = usedPoints(points, triangles);
  for (const Vec3& point : used) {
    if (!point.allFinite())
      return Problem{"", "a corner of this mesh is nowhere: one of its coordinates is no number",
                     "export the mesh anew"};
    if (point.cwiseAbs().maxCoeff() > kFarthestCorner)
      return Problem{"",
                     "a corner of this mesh is at " + placeText(point) + " cm, further than ten kilometres",
                     "move the mesh to the origin, look for a corner that strayed, and check the unit"};
  }
  if (const Vec3* stray = strayOf(used)) {
    return Problem{"",
                   "one corner of this mesh, at " + placeText(*stray) +
                       " cm, is a thousand times as far out as "
                       "the others",
                   "remove that corner or bring it back"};
  }
  for (const auto& triangle : triangles)
    if (hasArea(points[triangle[0]], points[triangle[1]], points[triangle[2]])) return Done{};
  return Problem{"",
                 "none of the " + std::to_string(triangles.size()) + " triangles of this mesh has an area",
                 "export a mesh of faces"};
}

}  // namespace sim
