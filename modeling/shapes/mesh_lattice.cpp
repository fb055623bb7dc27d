#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>
#include <span>

#include "modeling/shapes/mesh_cells.h"
#include "modeling/shapes/mesh_features.h"
#include "modeling/shapes/mesh_shape.h"
#include "modeling/shapes/quality.h"

namespace modeling {

namespace {

using sim::NodeIndex;

/// Scaled Jacobian that evening out strives for, and that no move onto the surface may go below: an outer
/// edge between two faces that lie on the same flat surface is bent by 10 degrees then, which stands out by
/// less than a tenth of a cell.
constexpr double kGoodJacobian = 0.45;
constexpr double kLeastJacobian = 0.17;
constexpr int kRounds = 12;
/// Shares of a cell within which an outer node belongs to a sharp corner or edge of the mesh.
constexpr double kCornerReach = 0.75;
constexpr double kEdgeReach = 0.5;

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

class Fitter {
 public:
  Fitter(const sim::TriangleMesh& mesh, double cellSize, Lattice& lattice)
      : mesh_(mesh), features_(mesh), cellSize_(cellSize), lattice_(lattice) {
    const std::size_t count = lattice.nodes.size();
    std::vector<std::array<std::uint32_t, 2>> cells, edges, rim;
    std::map<std::array<NodeIndex, 4>, std::pair<int, std::array<NodeIndex, 4>>> faces;
    for (std::uint32_t cell = 0; cell < lattice.cells.size(); ++cell) {
      const sim::CellCorners& corners = lattice.cells[cell];
      for (unsigned c = 0; c < 8; ++c) {
        cells.push_back({corners[c], cell});
        for (const unsigned axis : {1U, 2U, 4U}) edges.push_back({corners[c], corners[c ^ axis]});
      }
      for (const auto& face : kFaces) {
        const std::array<NodeIndex, 4> ring{corners[face[0]], corners[face[1]], corners[face[2]],
                                            corners[face[3]]};
        std::array<NodeIndex, 4> key = ring;
        std::sort(key.begin(), key.end());
        auto& entry = faces[key];
        ++entry.first;
        entry.second = ring;
      }
    }
    outer_.assign(count, 0);
    for (const auto& [key, face] : faces) {
      if (face.first != 1) continue;
      for (std::size_t c = 0; c < 4; ++c) {
        outer_[face.second[c]] = 1;
        rim.push_back({face.second[c], face.second[(c + 1) % 4]});
        rim.push_back({face.second[(c + 1) % 4], face.second[c]});
      }
    }
    cells_ = rowsOf(count, std::move(cells));
    edges_ = rowsOf(count, std::move(edges));
    rim_ = rowsOf(count, std::move(rim));
    pinned_.assign(count, 0);
  }

  void run() {
    for (int round = 0; round < kRounds; ++round) {
      evenOut();
      toSurface(kGoodJacobian);
    }
    pinFeatures();
    for (int round = 0; round < kRounds; ++round) {
      toSurface(kLeastJacobian);
      evenOut();
    }
    toSurface(kLeastJacobian);
  }

  double farthest() const {
    double farthest = 0.0;
    for (NodeIndex node = 0; node < outer_.size(); ++node)
      if (outer_[node] != 0) farthest = std::max(farthest, mesh_.nearest(lattice_.nodes[node]).distance);
    return farthest;
  }

 private:
  double worstAround(NodeIndex node) const {
    double worst = 1.0;
    for (const std::uint32_t cell : cells_.of(node))
      worst = std::min(worst, scaledJacobian(cornerPositions(lattice_.nodes, lattice_.cells[cell])));
    return worst;
  }

  /// As far towards the target as no cell gets worse than it was and worse than `least`. Answers whether all
  /// the way.
  bool moveTowards(NodeIndex node, const Vec3& target, double least) {
    const Vec3 before = lattice_.nodes[node];
    const double limit = std::min(least, worstAround(node));
    for (double share = 1.0; share > 0.1; share *= 0.5) {
      lattice_.nodes[node] = before + share * (target - before);
      if (worstAround(node) >= limit) return share == 1.0;
    }
    lattice_.nodes[node] = before;
    return false;
  }

  Vec3 meanOf(std::span<const std::uint32_t> nodes) const {
    Vec3 sum = Vec3::Zero();
    for (const std::uint32_t node : nodes) sum += lattice_.nodes[node];
    return sum / static_cast<double>(nodes.size());
  }

  /// Inner nodes to the middle of their neighbours; outer ones, along the surface, where a cell is skewed.
  void evenOut() {
    for (NodeIndex node = 0; node < outer_.size(); ++node) {
      if (pinned_[node] != 0 || worstAround(node) > 0.999) continue;
      if (outer_[node] == 0) {
        moveTowards(node, meanOf(edges_.of(node)), kGoodJacobian);
      } else if (worstAround(node) < kGoodJacobian) {
        moveTowards(node, mesh_.nearest(meanOf(rim_.of(node))).point, kLeastJacobian);
      }
    }
  }

  void toSurface(double least) {
    for (NodeIndex node = 0; node < outer_.size(); ++node) {
      if (outer_[node] != 0 && pinned_[node] == 0)
        moveTowards(node, mesh_.nearest(lattice_.nodes[node]).point, least);
    }
  }

  /// Each sharp corner takes the nearest outer node, then sharp edges take those that are near.
  void pinFeatures() {
    for (const Vec3& corner : features_.corners()) {
      NodeIndex best = sim::kNone;
      double nearest = kCornerReach * cellSize_;
      for (NodeIndex node = 0; node < outer_.size(); ++node) {
        if (outer_[node] == 0 || pinned_[node] != 0) continue;
        const double distance = (lattice_.nodes[node] - corner).norm();
        if (distance < nearest) {
          nearest = distance;
          best = node;
        }
      }
      if (best != sim::kNone) pin(best, corner);
    }
    if (!features_.hasEdges()) return;
    for (NodeIndex node = 0; node < outer_.size(); ++node) {
      if (outer_[node] == 0 || pinned_[node] != 0) continue;
      const auto edge = features_.nearestOnEdges(lattice_.nodes[node]);
      if (edge.distance < kEdgeReach * cellSize_ && isNearestOnRim(node, edge)) pin(node, edge.point);
    }
  }

  /// No neighbour on the surface is nearer to that point of the edge: else both would end up on it.
  bool isNearestOnRim(NodeIndex node, const sim::TriangleMesh::Nearest& edge) const {
    for (const std::uint32_t other : rim_.of(node)) {
      if ((lattice_.nodes[other] - edge.point).norm() < edge.distance) return false;
    }
    return true;
  }

  void pin(NodeIndex node, const Vec3& target) {
    const Vec3 before = lattice_.nodes[node];
    if (moveTowards(node, target, kLeastJacobian)) {
      pinned_[node] = 1;
    } else {
      lattice_.nodes[node] = before;
    }
  }

  const sim::TriangleMesh& mesh_;
  MeshFeatures features_;
  double cellSize_;
  Lattice& lattice_;
  std::vector<std::uint8_t> outer_, pinned_;
  Rows cells_, edges_, rim_;
};

std::string numberText(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", number);
  return text;
}

/// What is wrong with a mesh that should hold something, and how to mend it.
sim::Status checkClosed(const sim::TriangleMesh& mesh) {
  if (mesh.triangles().empty())
    return sim::Problem{"file", "there are no triangles in this mesh", "export it anew"};
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
  auto grid = cellsOf(mesh, cellSize, fit.addedCells);
  if (!grid) return grid.problem();
  Lattice lattice = latticeOf(*grid);
  if (lattice.cells.empty()) {
    return sim::Problem{"cellSize", "no cell of this size fits into the mesh, which is thinner everywhere",
                        "use smaller cells"};
  }
  Fitter fitter(mesh, cellSize, lattice);
  fitter.run();
  fit.farthest = fitter.farthest();
  fit.volumeShare = measure(lattice).volume / mesh.volume();
  const Eigen::AlignedBox3d box = mesh.box();
  const Vec3 size = box.diagonal().cwiseMax(1e-12);
  for (const Vec3& node : lattice.nodes)
    lattice.parameters.emplace_back((node - box.min()).cwiseQuotient(size).cwiseMax(0.0).cwiseMin(1.0));
  return completed(std::move(lattice), "use smaller cells");
}

}  // namespace modeling
