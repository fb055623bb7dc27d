#include "modeling/shapes/mesh_lattice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <tuple>

#include "modeling/shapes/mesh_cells.h"
#include "modeling/shapes/mesh_features.h"
#include "modeling/shapes/quality.h"
#include "sim/collider/surface_check.h"
#include "sim/collider/triangle_mesh.h"

namespace modeling {

namespace {

using sim::NodeIndex;

/// Scaled Jacobian that evening out strives for, and that no move onto the surface may go below: an outer
/// edge between two faces that lie on the same flat surface is bent by 7 degrees then, which stands out by
/// less than a tenth of a cell.
constexpr double kGoodJacobian = 0.45;
constexpr double kLeastJacobian = 0.12;
constexpr int kRounds = 20;
/// An edge of 0.3 of a cell is as bad as a scaled Jacobian of 0.18: it makes the step as short.
constexpr double kEdgeWeight = 0.6;
/// Shares of a cell within which an outer node belongs to a sharp corner or edge of the mesh.
constexpr double kCornerReach = 1.2;
constexpr double kEdgeReach = 1.2;

/// Rows of numbers, one row an owner.
struct Rows {
  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> items;

  std::span<const std::uint32_t> of(std::size_t owner) const {
    return {items.data() + first[owner], items.data() + first[owner + 1]};
  }
};

Rows rowsOf(std::size_t owners, std::vector<std::array<std::uint32_t, 2>> pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  Rows rows;
  rows.first.assign(owners + 1, 0);
  for (const auto& [owner, item] : pairs) {
    ++rows.first[owner + 1];
    rows.items.push_back(item);
  }
  std::partial_sum(rows.first.begin(), rows.first.end(), rows.first.begin());
  return rows;
}

/// Nodes at the corners of the filled cells, the longest axis innermost.
Lattice latticeOf(const CellGrid& grid) {
  std::array<std::size_t, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(),
                   [&](std::size_t a, std::size_t b) { return grid.count[a] < grid.count[b]; });
  const auto nodesAlong = [&](std::size_t axis) { return static_cast<std::size_t>(grid.count[axis]) + 1; };
  const auto place = [&](const std::array<int, 3>& corner) {
    return (static_cast<std::size_t>(corner[axes[0]]) * nodesAlong(axes[1]) +
            static_cast<std::size_t>(corner[axes[1]])) *
               nodesAlong(axes[2]) +
           static_cast<std::size_t>(corner[axes[2]]);
  };
  const auto cornerOf = [](const std::array<int, 3>& cell, unsigned c) {
    return std::array<int, 3>{cell[0] + static_cast<int>(c & 1U), cell[1] + static_cast<int>((c >> 1U) & 1U),
                              cell[2] + static_cast<int>(c >> 2U)};
  };
  std::vector<std::array<int, 3>> cells;
  for (std::array<int, 3> at{}; at[axes[0]] < grid.count[axes[0]]; ++at[axes[0]]) {
    for (at[axes[1]] = 0; at[axes[1]] < grid.count[axes[1]]; ++at[axes[1]]) {
      for (at[axes[2]] = 0; at[axes[2]] < grid.count[axes[2]]; ++at[axes[2]])
        if (grid.isFilled(at)) cells.push_back(at);
    }
    at[axes[1]] = at[axes[2]] = 0;
  }
  std::vector<NodeIndex> nodeAt(nodesAlong(0) * nodesAlong(1) * nodesAlong(2), sim::kNone);
  for (const auto& cell : cells)
    for (unsigned c = 0; c < 8; ++c) nodeAt[place(cornerOf(cell, c))] = 0;
  NodeIndex count = 0;
  for (NodeIndex& node : nodeAt)
    if (node == 0) node = count++;
  Lattice lattice;
  lattice.nodes.resize(count);
  for (const auto& cell : cells) {
    sim::CellCorners& corners = lattice.cells.emplace_back();
    for (unsigned c = 0; c < 8; ++c) {
      const auto corner = cornerOf(cell, c);
      corners[c] = nodeAt[place(corner)];
      lattice.nodes[corners[c]] = grid.corner + grid.cellSize * Vec3(corner[0], corner[1], corner[2]);
    }
  }
  return lattice;
}

constexpr std::array<std::array<unsigned, 4>, 6> kFaces{
    {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}};

double shortestEdge(const CornerPositions& corners) {
  double shortest = std::numeric_limits<double>::infinity();
  for (unsigned c = 0; c < 8; ++c) {
    for (const unsigned axis : {1U, 2U, 4U})
      if ((c & axis) == 0) shortest = std::min(shortest, (corners[c | axis] - corners[c]).squaredNorm());
  }
  return std::sqrt(shortest);
}

/// What an outer node lies on when all is fitted.
enum class Place : std::uint8_t { inside, face, edge, corner };

/// Which of the outer nodes belong on sharp edges and corners of the mesh. A node at the rim of two sides of
/// the staircase does where what is nearest, looking from either side, is bent sharply against each other:
/// near the rim of a cup the top is nearest to all, but from the side it is the wall.
class PlaceFinder {
 public:
  PlaceFinder(const sim::TriangleMesh& mesh, double cellSize)
      : mesh_(mesh), features_(mesh), cellSize_(cellSize) {
    for (unsigned side = 0; side < kSides; ++side) {
      std::vector<sim::TriangleMesh::Triangle> facing;
      for (const auto& triangle : mesh.triangles()) {
        const Vec3& a = mesh.points()[triangle[0]];
        const Vec3 normal =
            (mesh.points()[triangle[1]] - a).cross(mesh.points()[triangle[2]] - a).stableNormalized();
        if (normal.dot(direction(side)) > kFacing) facing.push_back(triangle);
      }
      if (features_.hasEdges() && !facing.empty()) sides_[side].emplace(mesh.points(), facing);
    }
  }

  const MeshFeatures& features() const { return features_; }

  /// `sides`: a bit for each side of cells that is bare at the node: 2 axis, and one more where it faces up.
  Place placeOf(const Vec3& node, unsigned sides) const {
    if (!features_.hasEdges()) return Place::face;
    std::vector<Vec3> normals;
    for (unsigned side = 0; side < kSides; ++side) {
      if (((sides >> side) & 1U) == 0 || !sides_[side]) continue;
      const auto there = sides_[side]->nearest(node);
      if (there.distance > kSight * cellSize_) continue;
      const auto& corners = sides_[side]->triangles()[there.triangle];
      const Vec3& a = mesh_.points()[corners[0]];
      normals.push_back(
          (mesh_.points()[corners[1]] - a).cross(mesh_.points()[corners[2]] - a).stableNormalized());
    }
    static const double kCosine = std::cos(MeshFeatures::kSharpAngle * std::numbers::pi / 180.0);
    for (const Vec3& left : normals) {
      for (const Vec3& right : normals) {
        if (left.dot(right) < kCosine && features_.nearestOnEdges(node).distance < kEdgeReach * cellSize_)
          return Place::edge;
      }
    }
    return Place::face;
  }

 private:
  static constexpr unsigned kSides = 6;
  static constexpr double kFacing = 0.3;  ///< cosine: faces turned further away are not of this side
  static constexpr double kSight = 1.5;   ///< cells

  static Vec3 direction(unsigned side) {
    Vec3 axis = Vec3::Zero();
    axis[side / 2] = side % 2 == 0 ? -1.0 : 1.0;
    return axis;
  }

  const sim::TriangleMesh& mesh_;
  MeshFeatures features_;
  double cellSize_;
  std::array<std::optional<sim::TriangleMesh>, kSides> sides_;
};

class Fitter {
 public:
  Fitter(const sim::TriangleMesh& mesh, double cellSize, Lattice& lattice)
      : mesh_(mesh), places_(mesh, cellSize), cellSize_(cellSize), lattice_(lattice) {
    const std::size_t count = lattice.nodes.size();
    std::vector<std::array<std::uint32_t, 2>> cells, edges;
    for (std::uint32_t cell = 0; cell < lattice.cells.size(); ++cell) {
      const sim::CellCorners& corners = lattice.cells[cell];
      for (unsigned c = 0; c < 8; ++c) {
        cells.push_back({corners[c], cell});
        for (const unsigned axis : {1U, 2U, 4U}) edges.push_back({corners[c], corners[c ^ axis]});
      }
    }
    cells_ = rowsOf(count, std::move(cells));
    edges_ = rowsOf(count, std::move(edges));
    findOuter();
  }

  void run() {
    for (int round = 0; round < kRounds; ++round) {
      evenOut();
      toSurface(kGoodJacobian);
    }
    for (int round = 0; round < kRounds; ++round) {
      toSurface(kLeastJacobian);
      evenOut();
    }
    toSurface(kLeastJacobian);
  }

  double farthest() const {
    double farthest = 0.0;
    for (NodeIndex node = 0; node < place_.size(); ++node)
      if (place_[node] != Place::inside)
        farthest = std::max(farthest, mesh_.nearest(lattice_.nodes[node]).distance);
    return farthest;
  }

 private:
  void findOuter() {
    struct Bare {
      int cells = 0;
      std::array<NodeIndex, 4> ring{};
      unsigned side = 0;
    };
    std::map<std::array<NodeIndex, 4>, Bare> faces;
    for (const sim::CellCorners& corners : lattice_.cells) {
      for (unsigned side = 0; side < kFaces.size(); ++side) {
        Bare bare{1, {}, side};
        for (unsigned c = 0; c < 4; ++c) bare.ring[c] = corners[kFaces[side][c]];
        std::array<NodeIndex, 4> key = bare.ring;
        std::sort(key.begin(), key.end());
        const auto [entry, isNew] = faces.try_emplace(key, bare);
        if (!isNew) ++entry->second.cells;
      }
    }
    std::vector<unsigned> sides(lattice_.nodes.size(), 0);
    std::vector<std::array<std::uint32_t, 2>> rim;
    for (const auto& [key, bare] : faces) {
      if (bare.cells != 1) continue;
      for (std::size_t c = 0; c < 4; ++c) {
        const NodeIndex next = bare.ring[(c + 1) % 4];
        sides[bare.ring[c]] |= 1U << bare.side;
        rim.push_back({bare.ring[c], next});
        rim.push_back({next, bare.ring[c]});
      }
    }
    rim_ = rowsOf(lattice_.nodes.size(), std::move(rim));
    place_.assign(lattice_.nodes.size(), Place::inside);
    for (NodeIndex node = 0; node < place_.size(); ++node)
      if (sides[node] != 0) place_[node] = places_.placeOf(lattice_.nodes[node], sides[node]);
    chooseCorners();
  }

  /// Each corner of the mesh takes the nearest node of its edges.
  void chooseCorners() {
    for (const Vec3& corner : places_.features().corners()) {
      NodeIndex best = sim::kNone;
      double nearest = kCornerReach * cellSize_;
      for (NodeIndex node = 0; node < place_.size(); ++node) {
        if (place_[node] != Place::edge) continue;
        const double distance = (lattice_.nodes[node] - corner).norm();
        if (distance < nearest) std::tie(nearest, best) = std::pair(distance, node);
      }
      if (best == sim::kNone) continue;
      place_[best] = Place::corner;
      cornerOf_[best] = corner;
    }
  }

  Vec3 onItsPlace(NodeIndex node, const Vec3& point) const {
    switch (place_[node]) {
      case Place::face:
        return mesh_.nearest(point).point;
      case Place::edge:
        return places_.features().nearestOnEdges(point).point;
      case Place::corner:
        return cornerOf_.at(node);
      case Place::inside:
        break;
    }
    return point;
  }

  /// The smallest scaled Jacobian, or what a short edge is as bad as.
  double worstAround(NodeIndex node) const {
    double worst = 1.0;
    for (const std::uint32_t cell : cells_.of(node)) {
      const CornerPositions corners = cornerPositions(lattice_.nodes, lattice_.cells[cell]);
      worst = std::min({worst, scaledJacobian(corners), kEdgeWeight * shortestEdge(corners) / cellSize_});
    }
    return worst;
  }

  /// As far towards the target as no cell gets worse than it was and worse than `least`.
  void moveTowards(NodeIndex node, const Vec3& target, double least) {
    const Vec3 before = lattice_.nodes[node];
    const double limit = std::min(least, worstAround(node));
    double share = 1.0;
    for (int halving = 0; halving < 4; ++halving, share *= 0.5) {
      lattice_.nodes[node] = before + share * (target - before);
      if (worstAround(node) >= limit) return;
    }
    lattice_.nodes[node] = before;
  }

  /// The mean of the neighbours: on an edge, of those that are on an edge too; on the surface, of those on
  /// it.
  Vec3 between(NodeIndex node) const {
    const auto neighbours = place_[node] == Place::inside ? edges_.of(node) : rim_.of(node);
    Vec3 all = Vec3::Zero(), along = Vec3::Zero();
    double count = 0.0;
    for (const std::uint32_t other : neighbours) {
      all += lattice_.nodes[other];
      if (place_[other] != Place::edge && place_[other] != Place::corner) continue;
      along += lattice_.nodes[other];
      count += 1.0;
    }
    const bool onEdge = place_[node] == Place::edge && count > 1.0;
    return onEdge ? Vec3(along / count) : Vec3(all / static_cast<double>(neighbours.size()));
  }

  /// Inner nodes to the middle of their neighbours; outer ones, along the surface, where a cell is skewed.
  void evenOut() {
    for (NodeIndex node = 0; node < place_.size(); ++node) {
      if (place_[node] == Place::inside) {
        moveTowards(node, between(node), kGoodJacobian);
      } else if (place_[node] != Place::corner && worstAround(node) < kGoodJacobian) {
        moveTowards(node, onItsPlace(node, between(node)), kLeastJacobian);
      }
    }
  }

  void toSurface(double least) {
    for (NodeIndex node = 0; node < place_.size(); ++node) {
      if (place_[node] != Place::inside) moveTowards(node, onItsPlace(node, lattice_.nodes[node]), least);
    }
  }

  const sim::TriangleMesh& mesh_;
  PlaceFinder places_;
  double cellSize_;
  Lattice& lattice_;
  std::vector<Place> place_;
  std::map<NodeIndex, Vec3> cornerOf_;
  Rows cells_, edges_, rim_;
};

std::string numberText(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", number);
  return text;
}

/// What is wrong with a mesh that should hold something, and how to mend it.
sim::Status checkClosed(const sim::TriangleMesh& mesh) {
  if (const sim::Status status = sim::checkSurface(mesh.points(), mesh.triangles()); !status)
    return sim::Problem{"file", status.problem().what, status.problem().remedy};
  const sim::TriangleMesh::Gaps& gaps = mesh.gaps();
  if (gaps.count() == 0) return sim::Done{};
  std::string what = "this mesh is not closed:";
  const auto add = [&](std::size_t count, const char* kind) {
    if (count > 0) what += (what.back() == ':' ? " " : ", ") + std::to_string(count) + kind;
  };
  add(gaps.openEdges, " edges of one face only");
  add(gaps.crowdedEdges, " edges of more than two faces");
  add(gaps.flippedEdges, " edges whose faces do not agree on what is outside");
  what += ", the first near (" + numberText(gaps.first.x()) + ", " + numberText(gaps.first.y()) + ", " +
          numberText(gaps.first.z()) + ") cm";
  const char* remedy = gaps.openEdges > 0
                           ? "fill its holes and merge its doubled corners, or use it as an obstacle"
                       : gaps.crowdedEdges > 0 ? "remove its inner faces, or use it as an obstacle"
                                               : "turn its faces to the same side (recalculate its normals)";
  return sim::Problem{"file", what, remedy};
}

}  // namespace

sim::Result<Lattice> fillMesh(const sim::TriangleMesh& mesh, double cellSize, MeshFit& fit) {
  if (auto status = checkClosed(mesh); !status) return status.problem();
  auto grid = cellsOf(mesh, cellSize);
  if (!grid) return grid.problem();
  fit.addedCells = grid->added;
  fit.onceShare = grid->onceShare;
  Lattice lattice = latticeOf(*grid);
  if (lattice.cells.empty()) {
    return sim::Problem{"cellSize", "no cell of this size fits into the mesh, which is thinner everywhere",
                        "use smaller cells"};
  }
  fit.crossings = sim::crossingsOf(mesh);
  Fitter fitter(mesh, cellSize, lattice);
  fitter.run();
  fit.farthest = fitter.farthest();
  fit.volumeShare = measure(lattice).volume / (mesh.volume() * fit.onceShare);
  const Eigen::AlignedBox3d box = mesh.box();
  const Vec3 size = box.diagonal().cwiseMax(1e-12);
  for (const Vec3& node : lattice.nodes)
    lattice.parameters.emplace_back((node - box.min()).cwiseQuotient(size).cwiseMax(0.0).cwiseMin(1.0));
  return completed(std::move(lattice), "use smaller cells");
}

}  // namespace modeling
