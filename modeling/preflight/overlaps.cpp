#include "modeling/preflight/overlaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <unordered_map>

#include "modeling/text/spelling.h"
#include "sim/collider/triangle_mesh.h"
#include "sim/control/driven.h"

namespace modeling {
namespace {

using sim::NodeIndex;
using sim::Vec3;

/// Of a node's distance to its nearest neighbour: as deep may it be in an obstacle that it stands on. It is
/// pushed out by less than is seen.
constexpr double kTouchesObstacle = 2e-3;
/// The same of another part: round shapes that touch cut into each other by the flatness of their cells.
constexpr double kTouchesPart = 0.05;

/// The sides of a cell, outward.
constexpr std::array<std::array<std::size_t, 4>, 6> kSides{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

/// The deepest of each pair.
class Deepest {
 public:
  void note(const Overlap& overlap) {
    const auto [found, fresh] = all_.try_emplace({overlap.part, overlap.other, overlap.obstacle}, overlap);
    if (!fresh && found->second.depth < overlap.depth) found->second = overlap;
  }
  std::vector<Overlap> sorted() const {
    std::vector<Overlap> list;
    for (const auto& [names, overlap] : all_) list.push_back(overlap);
    std::ranges::stable_sort(list, std::greater<>(), &Overlap::depth);
    return list;
  }

 private:
  std::map<std::tuple<std::string, std::string, bool>, Overlap> all_;
};

const std::string& partOf(const sim::Network& network, NodeIndex node) {
  return network.partNames[network.nodeParts[node]];
}

void noteObstacles(const sim::Network& network, const sim::Snapshot& start,
                   const sim::Environment& environment, const std::vector<sim::Track>& tracks,
                   Deepest& deepest) {
  for (std::uint32_t c = 0; c < environment.colliders.size(); ++c) {
    const sim::MovingCollider there = sim::colliderAt(environment.colliders[c], c, tracks, start.time).at;
    if (!there.active) continue;
    const Eigen::AlignedBox3d box = sim::boxOf(there.shape);
    const auto* surface = std::get_if<sim::SurfaceShape>(&there.shape.shape);
    const double margin = surface != nullptr ? surface->halfThickness : 0.0;
    std::uint32_t near = sim::kNone;
    for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
      const Vec3& at = start.positions[node];
      if (!std::isfinite(network.masses[node])) continue;
      if (!there.shape.isFloor() && box.exteriorDistance(at) > margin) continue;
      const sim::Intrusion found = sim::intrusion(there.shape, at, near);
      near = found.nearest;
      if (found.depth > kTouchesObstacle * static_cast<double>(network.radii[node]))
        deepest.note(
            {partOf(network, node), there.shape.name, true, found.depth, at, found.depth * found.normal});
    }
  }
}

/// A part of a body, and what is looked at of it. By itself its cells have a closed outside, which those of a
/// body of several lattices need not have.
struct Body {
  sim::FragmentId fragment = sim::kNone;
  sim::PartIndex part = 0;
  Eigen::AlignedBox3d box;
  std::vector<sim::CellIndex> cells;
  std::vector<NodeIndex> nodes;
  std::shared_ptr<const sim::TriangleMesh> outside;  ///< null until it is needed
};

std::vector<Body> bodiesOf(const sim::Network& network, const sim::Snapshot& start) {
  std::vector<Body> bodies;
  std::map<std::pair<sim::FragmentId, sim::PartIndex>, std::size_t> known;
  const auto bodyOf = [&](NodeIndex node, sim::PartIndex part) -> Body& {
    const sim::FragmentId fragment = start.broken->fragmentOfNode[node];
    const auto [found, fresh] = known.try_emplace({fragment, part}, bodies.size());
    if (fresh) bodies.push_back({fragment, part, {}, {}, {}, nullptr});
    return bodies[found->second];
  };
  for (sim::CellIndex cell = 0; cell < network.cellCount(); ++cell) {
    // Corners that were glued are of the part they were glued to.
    std::array<sim::PartIndex, 8> parts{};
    std::ranges::transform(network.cells[cell], parts.begin(),
                           [&](NodeIndex node) { return network.nodeParts[node]; });
    const auto own = std::ranges::max_element(
        parts, {}, [&](sim::PartIndex part) { return std::ranges::count(parts, part); });
    Body& body = bodyOf(network.cells[cell][0], *own);
    body.cells.push_back(cell);
    for (const NodeIndex corner : network.cells[cell]) body.box.extend(start.positions[corner]);
  }
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    Body& body = bodyOf(node, network.nodeParts[node]);
    body.nodes.push_back(node);
    body.box.extend(start.positions[node]);
  }
  return bodies;
}

/// The sides that only one of the body's cells has.
std::shared_ptr<const sim::TriangleMesh> outsideOf(const Body& body, const sim::Network& network,
                                                   const std::vector<Vec3>& positions) {
  using Side = std::array<NodeIndex, 4>;
  std::map<Side, std::pair<Side, int>> sides;
  for (const sim::CellIndex cell : body.cells) {
    for (const auto& corners : kSides) {
      Side side{};
      std::ranges::transform(corners, side.begin(), [&](std::size_t c) { return network.cells[cell][c]; });
      Side key = side;
      std::ranges::sort(key);
      ++sides.try_emplace(key, side, 0).first->second.second;
    }
  }
  std::unordered_map<NodeIndex, std::uint32_t> numbers;
  std::vector<Vec3> points;
  std::vector<sim::TriangleMesh::Triangle> triangles;
  const auto numberOf = [&](NodeIndex node) {
    const auto [found, fresh] = numbers.try_emplace(node, static_cast<std::uint32_t>(points.size()));
    if (fresh) points.push_back(positions[node]);
    return found->second;
  };
  for (const auto& [key, side] : sides) {
    if (side.second != 1) continue;
    std::array<std::uint32_t, 4> at{};
    std::ranges::transform(side.first, at.begin(), numberOf);
    triangles.push_back({at[0], at[1], at[2]});
    triangles.push_back({at[0], at[2], at[3]});
  }
  return std::make_shared<const sim::TriangleMesh>(std::move(points), triangles);
}

/// Notes what of `inner` is inside `outer`: nodes, and middles of cells, since a thin thing may have nodes on
/// its surface alone.
class PairOfBodies {
 public:
  PairOfBodies(const sim::Network& network, const sim::Snapshot& start, Deepest& deepest)
      : network_(network), positions_(start.positions), deepest_(deepest) {}

  void compare(const Body& inner, Body& outer) {
    if (outer.cells.empty()) return;
    const Eigen::AlignedBox3d common = inner.box.intersection(outer.box);
    std::vector<std::pair<Vec3, NodeIndex>> points;
    for (const NodeIndex node : inner.nodes)
      if (common.contains(positions_[node])) points.emplace_back(positions_[node], node);
    for (const sim::CellIndex cell : inner.cells) {
      Vec3 middle = Vec3::Zero();
      for (const NodeIndex corner : network_.cells[cell]) middle += positions_[corner] / 8.0;
      if (common.contains(middle)) points.emplace_back(middle, network_.cells[cell][0]);
    }
    if (points.empty()) return;
    if (!outer.outside) outer.outside = outsideOf(outer, network_, positions_);
    if (outer.outside->triangles().empty()) return;
    std::uint32_t near = sim::kNone;
    for (const auto& [at, node] : points) near = look(at, node, inner, outer, near);
  }

 private:
  std::uint32_t look(const Vec3& at, NodeIndex node, const Body& inner, const Body& outer,
                     std::uint32_t near) {
    const sim::TriangleMesh::Nearest nearest = outer.outside->nearest(at, near);
    const bool inside = nearest.normal.dot(at - nearest.point) < 0.0;
    if (inside && nearest.distance > kTouchesPart * static_cast<double>(network_.radii[node])) {
      deepest_.note({network_.partNames[inner.part], network_.partNames[outer.part], false, nearest.distance,
                     at, apart(inner.box, outer.box)});
    }
    return nearest.triangle;
  }

  /// cm: the shortest way along an axis that parts the boxes.
  static Vec3 apart(const Eigen::AlignedBox3d& inner, const Eigen::AlignedBox3d& outer) {
    Vec3 shortest = Vec3::Constant(std::numeric_limits<double>::infinity());
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      for (const double way : {outer.max()[axis] - inner.min()[axis], outer.min()[axis] - inner.max()[axis]})
        if (std::abs(way) < shortest.norm()) shortest = way * Vec3::Unit(axis);
    }
    return shortest;
  }

  const sim::Network& network_;
  const std::vector<Vec3>& positions_;
  Deepest& deepest_;
};

void noteBodies(const sim::Network& network, const sim::Snapshot& start, Deepest& deepest) {
  std::vector<Body> bodies = bodiesOf(network, start);
  // By where they begin along x, so that only those that overlap there are compared.
  std::ranges::sort(bodies, {}, [](const Body& body) { return body.box.min().x(); });
  PairOfBodies pair(network, start, deepest);
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    for (std::size_t b = a + 1; b < bodies.size() && bodies[b].box.min().x() <= bodies[a].box.max().x();
         ++b) {
      if (bodies[a].fragment == bodies[b].fragment || !bodies[a].box.intersects(bodies[b].box)) continue;
      pair.compare(bodies[a], bodies[b]);
      pair.compare(bodies[b], bodies[a]);
    }
  }
}

/// Each pair of parts once, by the deeper of the two.
void keepOneOfEachPair(std::vector<Overlap>& sorted) {
  std::vector<Overlap> kept;
  for (Overlap& overlap : sorted) {
    const bool told = std::ranges::any_of(kept, [&](const Overlap& other) {
      return !overlap.obstacle && !other.obstacle && other.part == overlap.other &&
             other.other == overlap.part;
    });
    if (!told) kept.push_back(std::move(overlap));
  }
  sorted = std::move(kept);
}

}  // namespace

std::string Overlap::text() const {
  std::ostringstream words;
  words.precision(3);
  const auto vector = [&](const sim::Vec3& of) {
    // Rounding of what is zero is not worth a reader's time.
    const sim::Vec3 clean =
        of.unaryExpr([](double number) { return std::abs(number) < 1e-9 ? 0.0 : number; });
    words << '(' << clean.x() << ", " << clean.y() << ", " << clean.z() << ')';
  };
  words << "the part " << inQuotes(part) << " begins " << depth << " cm inside the "
        << (obstacle ? "obstacle " : "part ") << inQuotes(other) << ", near ";
  vector(where);
  words << " cm, and is pushed out of it at once; move it by ";
  vector(wayOut);
  words << (obstacle ? " cm" : " cm, or glue the two");
  return words.str();
}

std::vector<Overlap> findOverlaps(const sim::Simulation& simulation, const sim::Environment& environment,
                                  const std::vector<sim::Track>& tracks) {
  const sim::Snapshot start = simulation.snapshot();
  Deepest deepest;
  noteObstacles(simulation.network(), start, environment, tracks, deepest);
  noteBodies(simulation.network(), start, deepest);
  std::vector<Overlap> all = deepest.sorted();
  keepOneOfEachPair(all);
  return all;
}

}  // namespace modeling
