#include "sim/collider/triangle_mesh.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "sim/base/parallel.h"

namespace sim {
namespace {

constexpr std::uint32_t kTrianglesInLeaf = 4;

/// Which part of a triangle is nearest: the face, an edge, or a corner.
enum class Feature { face, edge, corner };

struct OnTriangle {
  Vec3 point;
  Feature feature = Feature::face;
  unsigned index = 0;  ///< of the edge from that corner to the next, or of the corner
};

Vec3 unit(const Vec3& v) {
  const double length = v.stableNorm();
  return length > 0.0 ? Vec3(v / length) : Vec3(Vec3::Zero());
}

/// The nearest point of an edge or its ends.
OnTriangle onEdge(const Vec3& from, const Vec3& to, unsigned edge, const Vec3& point) {
  const Vec3 along = to - from;
  const double length = along.squaredNorm();
  const double share = length > 0.0 ? along.dot(point - from) / length : 0.0;
  if (!(share > 0.0)) return {from, Feature::corner, edge};
  if (share >= 1.0) return {to, Feature::corner, (edge + 1) % 3};
  return {from + share * along, Feature::edge, edge};
}

OnTriangle onTriangle(const std::array<Vec3, 3>& corners, const Vec3& normal, const Vec3& point) {
  bool above = normal.squaredNorm() > 0.0;
  for (unsigned c = 0; c < 3 && above; ++c) {
    const Vec3 inward = normal.cross(corners[(c + 1) % 3] - corners[c]);
    above = inward.dot(point - corners[c]) >= 0.0;
  }
  if (above) return {point - normal.dot(point - corners[0]) * normal, Feature::face, 0};
  OnTriangle best;
  double nearest = std::numeric_limits<double>::infinity();
  for (unsigned c = 0; c < 3; ++c) {
    const OnTriangle here = onEdge(corners[c], corners[(c + 1) % 3], c, point);
    const double squared = (here.point - point).squaredNorm();
    if (squared < nearest) {
      nearest = squared;
      best = here;
    }
  }
  return best;
}

/// An edge of a triangle, with its points in ascending order.
struct HalfEdge {
  std::uint32_t low, high, triangle, corner;
  bool upward;  ///< the triangle goes from low to high
};

std::vector<HalfEdge> halfEdges(const std::vector<TriangleMesh::Triangle>& triangles) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    for (std::uint32_t c = 0; c < 3; ++c) {
      const std::uint32_t a = triangles[t][c];
      const std::uint32_t b = triangles[t][(c + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), t, c, a < b});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& left, const HalfEdge& right) {
    return std::array{left.low, left.high, left.triangle} < std::array{right.low, right.high, right.triangle};
  });
  return edges;
}

}  // namespace

struct TriangleMesh::Candidate {
  double squared = std::numeric_limits<double>::infinity();
  OnTriangle on;
  std::uint32_t triangle = kNone;
};

TriangleMesh::TriangleMesh(std::vector<Vec3> points, const std::vector<Triangle>& triangles)
    : points_(std::move(points)) {
  for (const Triangle& triangle : triangles) {
    assert(triangle[0] < points_.size() && triangle[1] < points_.size() && triangle[2] < points_.size());
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
      triangles_.push_back(triangle);
  }
  findNormals();
  grow();
  if (closed()) measureThickness();
}

void TriangleMesh::findNormals() {
  cornerNormals_.assign(points_.size(), Vec3::Zero());
  edgeNormals_.assign(triangles_.size(), {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()});
  for (const Triangle& triangle : triangles_) {
    const Vec3 normal = unit(
        (points_[triangle[1]] - points_[triangle[0]]).cross(points_[triangle[2]] - points_[triangle[0]]));
    faceNormals_.push_back(normal);
    for (std::size_t c = 0; c < 3; ++c) {
      const Vec3 forward = points_[triangle[(c + 1) % 3]] - points_[triangle[c]];
      const Vec3 backward = points_[triangle[(c + 2) % 3]] - points_[triangle[c]];
      cornerNormals_[triangle[c]] +=
          std::atan2(forward.cross(backward).norm(), forward.dot(backward)) * normal;
    }
  }
  for (Vec3& normal : cornerNormals_) normal = unit(normal);
  const std::vector<HalfEdge> edges = halfEdges(triangles_);
  for (std::size_t first = 0; first < edges.size();) {
    std::size_t last = first;
    Vec3 sum = Vec3::Zero();
    for (;
         last < edges.size() && edges[last].low == edges[first].low && edges[last].high == edges[first].high;
         ++last)
      sum += faceNormals_[edges[last].triangle];
    for (std::size_t e = first; e < last; ++e) edgeNormals_[edges[e].triangle][edges[e].corner] = unit(sum);
    const std::size_t before = gaps_.count();
    if (last - first == 1) ++gaps_.openEdges;
    if (last - first > 2) ++gaps_.crowdedEdges;
    if (last - first == 2 && edges[first].upward == edges[first + 1].upward) ++gaps_.flippedEdges;
    if (before == 0 && gaps_.count() > 0)
      gaps_.first = 0.5 * (points_[edges[first].low] + points_[edges[first].high]);
    first = last;
  }
}

void TriangleMesh::grow() {
  if (triangles_.empty()) return;
  order_.resize(triangles_.size());
  std::iota(order_.begin(), order_.end(), 0U);
  std::vector<Vec3> middles;
  for (const Triangle& triangle : triangles_)
    middles.push_back((points_[triangle[0]] + points_[triangle[1]] + points_[triangle[2]]) / 3.0);
  branches_.emplace_back();
  split(0, 0, static_cast<std::uint32_t>(order_.size()), middles);
}

/// In halves across the longest axis of the middles: as deep as the logarithm of the triangles, wherever they
/// are.
void TriangleMesh::split(std::uint32_t branch, std::uint32_t first, std::uint32_t last,
                         const std::vector<Vec3>& middles) {
  Eigen::AlignedBox3d box, spread;
  for (std::uint32_t i = first; i < last; ++i) {
    for (const std::uint32_t point : triangles_[order_[i]]) box.extend(points_[point]);
    spread.extend(middles[order_[i]]);
  }
  branches_[branch].low = box.min();
  branches_[branch].high = box.max();
  if (last - first <= kTrianglesInLeaf) {
    branches_[branch].first = first;
    branches_[branch].count = last - first;
    return;
  }
  Eigen::Index axis = 0;
  spread.diagonal().maxCoeff(&axis);
  const std::uint32_t middle = first + (last - first) / 2;
  std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                   [&](std::uint32_t left, std::uint32_t right) {
                     const double a = middles[left][axis];
                     const double b = middles[right][axis];
                     return a != b ? a < b : left < right;
                   });
  const auto child = static_cast<std::uint32_t>(branches_.size());
  branches_[branch].first = child;
  branches_.resize(branches_.size() + 2);
  split(child, first, middle, middles);
  split(child + 1, middle, last, middles);
}

double TriangleMesh::squaredDistance(const Branch& branch, const Vec3& point) const {
  return (branch.low - point).cwiseMax(point - branch.high).cwiseMax(0.0).squaredNorm();
}

void TriangleMesh::look(std::uint32_t triangle, const Vec3& point, Candidate& best) const {
  const Triangle& corners = triangles_[triangle];
  // No point of it is nearer than its plane, which puts most out of the question. 1e-9 cm are more than
  // rounding.
  constexpr double kRounding = 1e-9;
  const double height = std::abs(faceNormals_[triangle].dot(point - points_[corners[0]])) - kRounding;
  if (height > 0.0 && height * height > best.squared) return;
  const OnTriangle on = onTriangle({points_[corners[0]], points_[corners[1]], points_[corners[2]]},
                                   faceNormals_[triangle], point);
  const double squared = (on.point - point).squaredNorm();
  if (squared < best.squared || (squared == best.squared && triangle < best.triangle))
    best = {squared, on, triangle};
}

/// From a point along a unit vector.
struct TriangleMesh::Ray {
  Vec3 from;
  Vec3 along;
  Vec3 inverse;  ///< of each coordinate of `along`

  /// Of the ray's way, where it meets the box; infinite where it does not.
  double way(const Branch& branch) const {
    const Vec3 low = (branch.low - from).cwiseProduct(inverse);
    const Vec3 high = (branch.high - from).cwiseProduct(inverse);
    const double enter = std::max(0.0, low.cwiseMin(high).maxCoeff());
    return enter <= low.cwiseMax(high).minCoeff() ? enter : std::numeric_limits<double>::infinity();
  }
  /// Where it meets the triangle (Moeller and Trumbore 1997), coming from its inside.
  double way(const Vec3& a, const Vec3& b, const Vec3& c) const {
    const Vec3 across = along.cross(c - a);
    const double determinant = across.dot(b - a);
    if (!(determinant < 0.0)) return std::numeric_limits<double>::infinity();
    const double u = across.dot(from - a) / determinant;
    const Vec3 other = (from - a).cross(b - a);
    const double v = other.dot(along) / determinant;
    const double way = other.dot(c - a) / determinant;
    const bool within = u >= 0.0 && v >= 0.0 && u + v <= 1.0 && way > 0.0;
    return within ? way : std::numeric_limits<double>::infinity();
  }
};

double TriangleMesh::wayThrough(std::uint32_t triangle) const {
  const Triangle& corners = triangles_[triangle];
  const Vec3 inward = -faceNormals_[triangle];
  if (inward.isZero(0.0)) return std::numeric_limits<double>::infinity();
  // A coordinate of zero would make the way to a box it stands on no number.
  const Vec3 along = (inward.array() == 0.0).select(1e-30, inward);
  const Ray ray{(points_[corners[0]] + points_[corners[1]] + points_[corners[2]]) / 3.0, inward,
                along.cwiseInverse()};
  double shortest = std::numeric_limits<double>::infinity();
  std::array<std::uint32_t, 64> waiting{};
  std::size_t count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const Branch& branch = branches_[waiting[--count]];
    if (ray.way(branch) >= shortest) continue;
    for (std::uint32_t i = 0; i < branch.count; ++i) {
      const Triangle& other = triangles_[order_[branch.first + i]];
      if (order_[branch.first + i] != triangle)
        shortest = std::min(shortest, ray.way(points_[other[0]], points_[other[1]], points_[other[2]]));
    }
    if (branch.count > 0) continue;
    waiting[count++] = branch.first;
    waiting[count++] = branch.first + 1;
  }
  return shortest;
}

void TriangleMesh::measureThickness() {
  constexpr double kLeastShare = 1e-3;
  constexpr std::size_t kGrain = 256;
  std::vector<double> ways(triangles_.size());
  parallelRanges(ways.size(), kGrain, Sharing::balanced, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) ways[t] = wayThrough(static_cast<std::uint32_t>(t));
  });
  const double extent = box().diagonal().norm();
  const double least = *std::min_element(ways.begin(), ways.end());
  leastThickness_ = std::isfinite(least) ? std::max(least, kLeastShare * extent) : 0.0;
}

TriangleMesh::Nearest TriangleMesh::nearest(const Vec3& point, std::uint32_t near) const {
  assert(!triangles_.empty());
  Candidate best;
  if (near < triangles_.size()) look(near, point, best);
  // Halving four thousand million triangles takes 32 levels; each leaves one sibling to be looked at later.
  std::array<std::uint32_t, 64> waiting{};
  std::size_t count = 0;
  waiting[count++] = 0;
  while (count > 0) {
    const Branch& branch = branches_[waiting[--count]];
    if (squaredDistance(branch, point) > best.squared) continue;
    for (std::uint32_t i = 0; i < branch.count; ++i) look(order_[branch.first + i], point, best);
    if (branch.count > 0) continue;
    const bool leftFirst = squaredDistance(branches_[branch.first], point) <=
                           squaredDistance(branches_[branch.first + 1], point);
    waiting[count++] = branch.first + (leftFirst ? 1 : 0);
    waiting[count++] = branch.first + (leftFirst ? 0 : 1);
  }
  // A point that is no number, or so far out that its square is none, is nearest to nothing.
  if (best.triangle == kNone) {
    const Vec3& anywhere = points_[triangles_[order_.front()][0]];
    return {anywhere, Vec3::UnitZ(), (point - anywhere).stableNorm(), order_.front()};
  }
  Nearest nearest{best.on.point, faceNormals_[best.triangle], std::sqrt(best.squared), best.triangle};
  if (best.on.feature == Feature::edge) nearest.normal = edgeNormals_[best.triangle][best.on.index];
  if (best.on.feature == Feature::corner)
    nearest.normal = cornerNormals_[triangles_[best.triangle][best.on.index]];
  return nearest;
}

double TriangleMesh::signedDistance(const Vec3& point) const {
  const Nearest there = nearest(point);
  return (point - there.point).dot(there.normal) < 0.0 ? -there.distance : there.distance;
}

double TriangleMesh::volume() const {
  double sum = 0.0;
  for (const Triangle& triangle : triangles_)
    sum += points_[triangle[0]].dot(points_[triangle[1]].cross(points_[triangle[2]])) / 6.0;
  return sum;
}

Eigen::AlignedBox3d TriangleMesh::box() const {
  return branches_.empty() ? Eigen::AlignedBox3d() : Eigen::AlignedBox3d(branches_[0].low, branches_[0].high);
}

std::size_t TriangleMesh::memoryBytes() const {
  return points_.capacity() * sizeof(Vec3) * 2 +
         triangles_.capacity() * (sizeof(Triangle) + 4 * sizeof(Vec3)) +
         order_.capacity() * sizeof(std::uint32_t) + branches_.capacity() * sizeof(Branch);
}

}  // namespace sim
