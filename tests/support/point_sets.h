#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <vector>

#include "sim/surface/surface_mesh.h"

namespace tests {

/// The points of the surface's fragments, by id.
inline std::map<sim::FragmentId, std::vector<sim::Vec3>> pointsByFragment(const sim::SurfaceMesh& mesh) {
  std::map<sim::FragmentId, std::vector<sim::Vec3>> points;
  for (const auto& face : mesh.faces) {
    for (unsigned c = 0; c < face.cornerCount; ++c)
      points[face.fragment].push_back(mesh.points[face.points[c]]);
  }
  return points;
}

/// The largest distance of a point of one set from the nearest of the other, both ways (Hausdorff): 0 for
/// equal sets, infinite where one is empty.
inline double apart(const std::vector<sim::Vec3>& left, const std::vector<sim::Vec3>& right) {
  double largest = 0.0;
  const auto byX = [](const sim::Vec3& a, const sim::Vec3& b) { return a.x() < b.x(); };
  const auto oneWay = [&](const auto& from, auto to) {
    std::sort(to.begin(), to.end(), byX);
    for (const sim::Vec3& point : from) {
      double nearest = INFINITY;
      const auto middle = std::lower_bound(to.begin(), to.end(), point, byX);
      for (auto other = middle; other != to.end() && other->x() - point.x() < nearest; ++other)
        nearest = std::min(nearest, (point - *other).norm());
      for (auto other = middle; other != to.begin() && point.x() - std::prev(other)->x() < nearest; --other)
        nearest = std::min(nearest, (point - *std::prev(other)).norm());
      largest = std::max(largest, nearest);
    }
  };
  oneWay(left, right);
  oneWay(right, left);
  return left.empty() || right.empty() ? INFINITY : largest;
}

}  // namespace tests
