#include "modeling/preflight/escape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace modeling {
namespace {

using sim::Vec3;

/// Of the depth: a little more where the deepest point was not met exactly, and up to what a curve needs.
constexpr std::array kMultiples{1.0, 1.02, 1.1, 1.3, 1.6, 2.0, 3.0, 5.0};
/// Moves that are no longer than others by more are as good, so that "up" wins among equals.
constexpr double kAsGood = 1e-9;

/// How far `moved` goes along a unit direction until it is past `still`.
double pastBox(const Vec3& along, const Eigen::AlignedBox3d& moved, const Eigen::AlignedBox3d& still) {
  const auto furthest = [](const Eigen::AlignedBox3d& box, const Vec3& way) {
    return box.center().dot(way) + 0.5 * box.sizes().dot(way.cwiseAbs());
  };
  return furthest(still, along) + furthest(moved, -along);
}

}  // namespace

std::optional<Vec3> shortEscape(double depth, const Vec3& wayOut, const Eigen::AlignedBox3d& moved,
                                const Eigen::AlignedBox3d& still,
                                const std::function<bool(const Vec3&)>& isFree) {
  std::vector<Vec3> directions{Vec3::UnitZ()};
  for (const Vec3& axis : {Vec3(Vec3::UnitX()), Vec3(Vec3::UnitY())}) {
    directions.push_back(axis);
    directions.push_back(-axis);
  }
  directions.push_back(-Vec3::UnitZ());
  // A way that is an axis but for rounding is that axis.
  const auto isNear = [&](const Vec3& axis) { return (axis - wayOut).norm() < 1e-6; };
  if (std::ranges::none_of(directions, isNear)) directions.push_back(wayOut);
  struct Try {
    double length;
    Vec3 along;
  };
  std::vector<Try> tries;
  for (const Vec3& along : directions) {
    for (const double multiple : kMultiples) tries.push_back({multiple * depth, along});
    if (moved.isEmpty() || still.isEmpty()) continue;
    if (const double length = pastBox(along, moved, still); length > 0.0) tries.push_back({length, along});
  }
  std::ranges::stable_sort(tries, {},
                           [&](const Try& way) { return std::round(way.length / (kAsGood * depth)); });
  for (const Try& way : tries) {
    if (isFree(way.length * way.along)) return way.length * way.along;
  }
  return std::nullopt;
}

}  // namespace modeling
