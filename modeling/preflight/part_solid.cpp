#include "modeling/preflight/part_solid.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

#include "modeling/shapes/quality.h"
#include "sim/base/parallel.h"
#include "sim/network/cell_shape.h"
#include "sim/network/wedge.h"

namespace modeling {
namespace {

using Triangle = sim::TriangleMesh::Triangle;

/// Facets that meet at a sharper angle are an edge of the part, not a curve cut into facets.
const double kSmooth = std::cos(0.9);
/// Samples that a thread takes at once.
constexpr std::size_t kGrain = 512;
/// A doubly curved surface bulges along both of a facet's directions.
constexpr double kBothWays = 2.0;

double shortestEdge(const CornerPositions& corners) {
  double shortest = std::numeric_limits<double>::infinity();
  for (const sim::CellEdge& edge : sim::kCellEdges) {
    const double length = (corners[edge.high] - corners[edge.low]).norm();
    if (length > 0.0) shortest = std::min(shortest, length);
  }
  return std::isfinite(shortest) ? shortest : 0.0;
}

double longestEdge(const std::vector<Vec3>& points, const Triangle& triangle) {
  const Vec3 &a = points[triangle[0]], &b = points[triangle[1]], &c = points[triangle[2]];
  return std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
}

double meanEdge(const sim::Network& network, const PartCells& part) {
  double sum = 0.0;
  for (const sim::CellCorners& cell : part.cells)
    sum += shortestEdge(cornerPositions(network.positions, cell));
  if (!part.cells.empty()) return sum / static_cast<double>(part.cells.size());
  for (const sim::NodeIndex node : part.nodes) sum += static_cast<double>(network.radii[node]);
  return part.nodes.empty() ? 0.0 : sum / static_cast<double>(part.nodes.size());
}

struct Side {
  std::array<sim::NodeIndex, 4> sorted;
  sim::SideNodes side;
};

/// The sides that one cell alone has.
std::vector<sim::SideNodes> outsideOf(std::span<const sim::CellCorners> cells) {
  std::vector<Side> sides;
  sides.reserve(6 * cells.size());
  for (const sim::CellCorners& cell : cells) {
    for (std::uint32_t s = 0; s < 6; ++s) {
      const sim::SideNodes side = sim::sideNodes(cell, s);
      if (side.hasCollapsed()) continue;
      sides.push_back({side.nodes, side});
      std::ranges::sort(sides.back().sorted);
    }
  }
  std::ranges::stable_sort(sides, {}, &Side::sorted);
  std::vector<sim::SideNodes> outside;
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first + 1;
    while (last < sides.size() && sides[last].sorted == sides[first].sorted) ++last;
    if (last - first == 1) outside.push_back(sides[first].side);
    first = last;
  }
  return outside;
}

Vec3 within(const CornerPositions& corners, const Vec3& share) {
  Vec3 at = Vec3::Zero();
  for (std::size_t c = 0; c < 8; ++c) {
    double weight = 1.0;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      weight *= (c >> axis) & 1U ? share[axis] : 1.0 - share[axis];
    at += weight * corners[c];
  }
  return at;
}

/// How many points along each of a cell's edges leave no more than `spacing` between them.
std::array<int, 3> pointsAlong(const CornerPositions& corners, double spacing) {
  std::array<int, 3> count{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double length = (corners[std::size_t{1} << axis] - corners[0]).norm();
    count[axis] =
        static_cast<int>(std::clamp(std::ceil(length / spacing - 0.5), 1.0, 1.0 * PartSolid::kMostAlong));
  }
  return count;
}

}  // namespace

PartSolid::PartSolid(const sim::Network& network, PartCells part)
    : network_(network),
      part_(std::move(part)),
      edge_(meanEdge(network, part_)),
      occupancy_(part_.box, edge_) {
  for (const sim::CellCorners& cell : part_.cells) {
    Eigen::AlignedBox3d box;
    for (const sim::NodeIndex node : cell) box.extend(network.positions[node]);
    occupancy_.add(box);
  }
}

void PartSolid::prepare() {
  if (surface_ || part_.cells.empty()) return;
  std::vector<Vec3> points;
  for (const sim::NodeIndex node : part_.nodes) points.push_back(network_.positions[node]);
  const auto number = [&](sim::NodeIndex node) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(part_.nodes, node) - part_.nodes.begin());
  };
  std::vector<Triangle> triangles;
  for (const sim::SideNodes& side : outsideOf(part_.cells)) {
    const auto& [a, b, c, d] = side.nodes;
    triangles.push_back({number(a), number(b), number(c)});
    if (!side.isTriangle()) triangles.push_back({number(a), number(c), number(d)});
  }
  if (triangles.empty()) return;
  measureFacets(points, triangles);
  surface_.emplace(std::move(points), triangles);
}

/// A circle through the corners of a chord of length e, whose neighbours turn by an angle t, bulges by
/// e/2 tan(t/4) over it.
void PartSolid::measureFacets(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
  std::vector<Vec3> normals;
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> firstOf;
  // By corner: where a curve ends at an edge, what is nearest to a point beyond it may be a triangle across.
  std::vector<float> bulges(points.size(), 0.0F);
  const auto meet = [&](std::uint32_t t, std::uint32_t other) {
    const double turn = normals[t].dot(normals[other]);
    if (turn < kSmooth) return;
    const double share = kBothWays * 0.5 * std::tan(std::acos(std::min(turn, 1.0)) / 4.0);
    for (const std::uint32_t facet : {t, other}) {
      const auto bulge = static_cast<float>(share * longestEdge(points, triangles[facet]));
      for (const std::uint32_t point : triangles[facet]) bulges[point] = std::max(bulges[point], bulge);
    }
  };
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    normals.push_back((points[b] - points[a]).cross(points[c] - points[a]).stableNormalized());
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const auto [low, high] = std::minmax(triangles[t][corner], triangles[t][(corner + 1) % 3]);
      const auto [entry, isNew] = firstOf.try_emplace({low, high}, t);
      if (!isNew) meet(t, entry->second);
    }
  }
  for (const auto& [a, b, c] : triangles) cutOff_.push_back(std::max({bulges[a], bulges[b], bulges[c]}));
}

std::optional<PartSolid::Inside> PartSolid::inside(const Vec3& point, double tolerance,
                                                   std::uint32_t& near) const {
  if (!surface_ || !occupancy_.at(point)) return std::nullopt;
  const sim::TriangleMesh::Nearest nearest = surface_->nearest(point, near);
  near = nearest.triangle;
  const Vec3 out = nearest.point - point;
  if (nearest.distance <= tolerance + static_cast<double>(cutOff_[nearest.triangle])) return std::nullopt;
  if (out.dot(nearest.normal) <= 0.0) return std::nullopt;
  return Inside{nearest.distance, point, out / nearest.distance};
}

template <class Visit>
void PartSolid::visitCell(std::size_t cell, double spacing, const Eigen::AlignedBox3d& box,
                          const Visit& visit) const {
  const CornerPositions corners = cornerPositions(network_.positions, part_.cells[cell]);
  Eigen::AlignedBox3d own;
  for (const Vec3& corner : corners) own.extend(corner);
  if (!own.intersects(box)) return;
  const std::array<int, 3> count = pointsAlong(corners, spacing);
  for (int i = 0; i < count[0]; ++i) {
    for (int j = 0; j < count[1]; ++j) {
      for (int k = 0; k < count[2]; ++k)
        visit(within(corners, {(i + 0.5) / count[0], (j + 0.5) / count[1], (k + 0.5) / count[2]}));
    }
  }
}

/// The deepest of what one thread has looked at; of equally deep ones the first, so that all threads together
/// always find the same.
struct PartSolid::Deepest {
  Inside inside;
  std::size_t index = 0;

  void take(const Inside& found, std::size_t at) {
    if (found.depth < inside.depth || (found.depth == inside.depth && at >= index)) return;
    inside = found;
    index = at;
  }
};

template <class Visit>
void PartSolid::visitSamples(std::size_t index, double spacing, const Eigen::AlignedBox3d& box,
                             const Visit& visit) const {
  if (index < part_.nodes.size()) {
    visit(network_.positions[part_.nodes[index]]);
  } else {
    visitCell(index - part_.nodes.size(), spacing, box, visit);
  }
}

/// Whether any point to be looked at is where something of this one may be: else no surface is needed.
bool PartSolid::mayHold(const PartSolid& other, const Look& look) const {
  const Eigen::AlignedBox3d reach = part_.box.translated(-look.move);
  if (part_.cells.empty() || !reach.intersects(other.box())) return false;
  const double spacing = std::min(edge_, other.edge_);
  std::atomic<bool> found{false};
  sim::parallelRanges(other.sampleCount(), kGrain, sim::Sharing::balanced,
                      [&](std::size_t begin, std::size_t end) {
                        for (std::size_t index = begin; index < end && !found; ++index) {
                          other.visitSamples(index, spacing, reach, [&](const Vec3& point) {
                            if (occupancy_.at(point + look.move)) found = true;
                          });
                        }
                      });
  return found;
}

PartSolid::Inside PartSolid::deepestOf(const PartSolid& other, const Look& look) {
  Deepest deepest;
  if (!mayHold(other, look)) return deepest.inside;
  prepare();
  const double spacing = std::min(edge_, other.edge_);
  const Eigen::AlignedBox3d reach = part_.box.translated(-look.move);
  std::mutex merging;
  std::atomic<bool> enough{false};
  sim::parallelRanges(other.sampleCount(), kGrain, sim::Sharing::balanced,
                      [&](std::size_t begin, std::size_t end) {
                        std::uint32_t near = sim::kNone;
                        Deepest here;
                        for (std::size_t index = begin; index < end && !enough; ++index) {
                          other.visitSamples(index, spacing, reach, [&](const Vec3& point) {
                            if (look.any && here.inside.depth > 0.0) return;
                            if (const auto found = inside(point + look.move, look.tolerance, near))
                              here.take(*found, index);
                          });
                          if (look.any && here.inside.depth > 0.0) enough = true;
                        }
                        const std::lock_guard lock(merging);
                        deepest.take(here.inside, here.index);
                      });
  return deepest.inside;
}

std::vector<PartCells> partsOf(const sim::Network& network, const std::vector<std::size_t>& cellCounts) {
  std::vector<PartCells> parts(cellCounts.size());
  const std::span<const sim::CellCorners> cells(network.cells);
  std::size_t first = 0;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    parts[p].cells = cells.subspan(first, cellCounts[p]);
    first += cellCounts[p];
    for (const sim::CellCorners& cell : parts[p].cells)
      parts[p].nodes.insert(parts[p].nodes.end(), cell.begin(), cell.end());
    std::ranges::sort(parts[p].nodes);
    const auto twice = std::ranges::unique(parts[p].nodes);
    parts[p].nodes.erase(twice.begin(), twice.end());
  }
  for (sim::NodeIndex node = 0; node < network.nodeCount(); ++node) {
    const sim::PartIndex part = network.nodeParts[node];
    if (part < parts.size() && parts[part].cells.empty()) parts[part].nodes.push_back(node);
  }
  for (PartCells& part : parts) {
    for (const sim::NodeIndex node : part.nodes) part.box.extend(network.positions[node]);
  }
  return parts;
}

}  // namespace modeling
