#include "modeling/import/polygon.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace modeling {
namespace {

using sim::Vec3;
using Flat = Eigen::Vector2d;

/// Twice the area with its direction, after Newell: right for rings bent inwards, too.
Vec3 normalOf(const std::vector<std::uint32_t>& ring, const std::vector<Vec3>& points) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    sum += (points[ring[i]] - points[ring[0]]).cross(points[ring[i + 1]] - points[ring[0]]);
  return sum;
}

/// Seen along the axis nearest to the normal, counter-clockwise.
std::vector<Flat> flattened(const std::vector<std::uint32_t>& ring, const std::vector<Vec3>& points) {
  const Vec3 normal = normalOf(ring, points);
  Eigen::Index along = 0;
  normal.cwiseAbs().maxCoeff(&along);
  const double turn = normal[along] < 0.0 ? -1.0 : 1.0;
  std::vector<Flat> flat;
  for (const std::uint32_t point : ring)
    flat.emplace_back(points[point][(along + 1) % 3], turn * points[point][(along + 2) % 3]);
  return flat;
}

double cross(const Flat& a, const Flat& b, const Flat& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

class EarCutter {
 public:
  explicit EarCutter(std::vector<Flat> flat) : flat_(std::move(flat)) {
    for (std::size_t i = 0; i < flat_.size(); ++i) left_.push_back(i);
  }

  /// Three numbers of corners each. A ring without an ear, which passes through itself, loses one corner
  /// after another all the same.
  std::vector<std::array<std::size_t, 3>> run() {
    std::vector<std::array<std::size_t, 3>> made;
    // A convex one becomes a fan about its first corner, as most programs have it.
    std::size_t at = 1;
    std::size_t tried = 0;
    while (left_.size() > 3) {
      const std::size_t count = left_.size();
      at %= count;
      if (!isEar(at) && tried < count) {
        ++at;
        ++tried;
        continue;
      }
      made.push_back({left_[(at + count - 1) % count], left_[at], left_[(at + 1) % count]});
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(at));
      tried = 0;
    }
    made.push_back({left_[0], left_[1], left_[2]});
    return made;
  }

 private:
  bool isEar(std::size_t at) const {
    const std::size_t count = left_.size();
    const std::size_t before = (at + count - 1) % count;
    const std::size_t after = (at + 1) % count;
    const Flat& a = flat_[left_[before]];
    const Flat& b = flat_[left_[at]];
    const Flat& c = flat_[left_[after]];
    if (!(cross(a, b, c) > 0.0)) return false;
    for (std::size_t i = 0; i < count; ++i) {
      if (i == before || i == at || i == after) continue;
      const Flat& p = flat_[left_[i]];
      if (p == a || p == b || p == c) continue;
      if (cross(a, b, p) >= 0.0 && cross(b, c, p) >= 0.0 && cross(c, a, p) >= 0.0) return false;
    }
    return true;
  }

  std::vector<Flat> flat_;
  std::vector<std::size_t> left_;
};

}  // namespace

void addTrianglesOf(std::vector<std::uint32_t> ring, const std::vector<Vec3>& points,
                    std::vector<std::array<std::uint32_t, 3>>& triangles) {
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (ring.size() < 3) return;
  if (ring.size() == 3) {
    triangles.push_back({ring[0], ring[1], ring[2]});
    return;
  }
  for (const auto& ear : EarCutter(flattened(ring, points)).run())
    triangles.push_back({ring[ear[0]], ring[ear[1]], ring[ear[2]]});
}

}  // namespace modeling
