#include "modeling/shapes/quality.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

namespace modeling {
namespace {

constexpr std::array<std::array<std::size_t, 2>, 12> kEdges{
    {{0, 1}, {2, 3}, {4, 5}, {6, 7}, {0, 2}, {1, 3}, {4, 6}, {5, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

struct EdgeRange {
  double shortest = std::numeric_limits<double>::infinity(), longest = 0.0, sum = 0.0;
};

EdgeRange edgeRange(const CornerPositions& corners) {
  EdgeRange range;
  for (const auto& [start, end] : kEdges) {
    const double length = (corners[end] - corners[start]).norm();
    range.shortest = std::min(range.shortest, length);
    range.longest = std::max(range.longest, length);
    range.sum += length;
  }
  return range;
}

double tripleProduct(const Vec3& a, const Vec3& b, const Vec3& c) {
  return a.cross(b).dot(c);
}

/// Nothing where an edge has no length.
std::optional<double> scaledJacobianAt(const CornerPositions& corners, std::size_t corner) {
  // Every edge is taken in the direction of its axis, so that a cube gives +1 at each corner.
  Vec3 edges[3];
  double lengths = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::size_t other = corner ^ (std::size_t{1} << axis);
    edges[axis] = corners[std::max(corner, other)] - corners[std::min(corner, other)];
    lengths *= edges[axis].norm();
  }
  if (!(lengths > 0.0)) return std::nullopt;
  return tripleProduct(edges[0], edges[1], edges[2]) / lengths;
}

/// Whether its edges lead to three different places. At merged corners they do not, nor beside a side that
/// has collapsed to an edge.
bool hasThreeNeighbours(const CornerPositions& corners, std::size_t corner) {
  const Vec3 &x = corners[corner ^ 1U], &y = corners[corner ^ 2U], &z = corners[corner ^ 4U];
  return x != y && y != z && z != x;
}

}  // namespace

CornerPositions cornerPositions(const std::vector<Vec3>& nodes, const sim::CellCorners& cell) {
  CornerPositions corners;
  for (std::size_t corner = 0; corner < 8; ++corner) corners[corner] = nodes[cell[corner]];
  return corners;
}

double scaledJacobian(const CornerPositions& corners) {
  double smallest = 1.0;
  for (std::size_t corner = 0; corner < 8; ++corner)
    smallest = std::min(smallest, scaledJacobianAt(corners, corner).value_or(0.0));
  return smallest;
}

double scaledJacobianOfWedge(const CornerPositions& corners) {
  std::optional<double> smallest;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    if (!hasThreeNeighbours(corners, corner)) continue;
    const std::optional<double> here = scaledJacobianAt(corners, corner);
    if (here) smallest = std::min(smallest.value_or(1.0), *here);
  }
  return smallest.value_or(0.0);
}

double cellAspect(const CornerPositions& corners) {
  const EdgeRange range = edgeRange(corners);
  return range.longest / range.shortest;
}

double cellVolume(const CornerPositions& corners) {
  // The Jacobian determinant of the trilinear map is quadratic in each coordinate, so that two Gauss points
  // an axis integrate it exactly.
  const double low = 0.5 - 0.5 / std::numbers::sqrt3;
  double volume = 0.0;
  for (std::size_t point = 0; point < 8; ++point) {
    std::array<double, 3> at{};
    for (std::size_t axis = 0; axis < 3; ++axis) at[axis] = (point >> axis) & 1U ? 1.0 - low : low;
    std::array<Vec3, 3> derivatives{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    for (std::size_t corner = 0; corner < 8; ++corner)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double weight = 1.0;
        for (std::size_t k = 0; k < 3; ++k) {
          const bool far = ((corner >> k) & 1U) != 0;
          weight *= k == axis ? (far ? 1.0 : -1.0) : (far ? at[k] : 1.0 - at[k]);
        }
        derivatives[axis] += weight * corners[corner];
      }
    volume += tripleProduct(derivatives[0], derivatives[1], derivatives[2]) / 8.0;
  }
  return volume;
}

LatticeQuality measure(const Lattice& lattice) {
  LatticeQuality quality;
  if (lattice.cells.empty()) return quality;
  quality.minScaledJacobian = std::numeric_limits<double>::infinity();
  quality.minEdge = std::numeric_limits<double>::infinity();
  double jacobians = 0.0, aspects = 0.0, edges = 0.0;
  for (std::size_t cell = 0; cell < lattice.cells.size(); ++cell) {
    const CornerPositions corners = cornerPositions(lattice.nodes, lattice.cells[cell]);
    const EdgeRange range = edgeRange(corners);
    const double jacobian = scaledJacobian(corners), aspect = range.longest / range.shortest;
    edges += range.sum;
    jacobians += jacobian;
    aspects += aspect;
    if (jacobian < quality.minScaledJacobian) {
      quality.minScaledJacobian = jacobian;
      quality.mostSkewedCell = static_cast<sim::CellIndex>(cell);
    }
    if (aspect > quality.maxAspect) {
      quality.maxAspect = aspect;
      quality.longestCell = static_cast<sim::CellIndex>(cell);
    }
    quality.minEdge = std::min(quality.minEdge, range.shortest);
    quality.maxEdge = std::max(quality.maxEdge, range.longest);
    quality.volume += cellVolume(corners);
  }
  const auto count = static_cast<double>(lattice.cells.size());
  quality.meanScaledJacobian = jacobians / count;
  quality.meanAspect = aspects / count;
  quality.meanEdge = edges / (12.0 * count);
  return quality;
}

}  // namespace modeling
