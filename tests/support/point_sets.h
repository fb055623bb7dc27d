#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "sim/network/surface_mesh.h"

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
  const auto oneWay = [&largest](const auto& from, const auto& to) {
    for (const sim::Vec3& point : from) {
      double nearest = INFINITY;
      for (const sim::Vec3& other : to) nearest = std::min(nearest, (point - other).norm());
      largest = std::max(largest, nearest);
    }
  };
  oneWay(left, right);
  oneWay(right, left);
  return left.empty() || right.empty() ? INFINITY : largest;
}

}  // namespace tests
