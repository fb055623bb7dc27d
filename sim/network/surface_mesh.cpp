#include "sim/network/surface_mesh.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <numeric>

#include <Eigen/Geometry>

#include "sim/base/random.h"

namespace sim {

namespace {

/// Seed of the shards' shapes, so that a node's shard looks the same in every frame and every run.
constexpr std::uint64_t kShardSeed = 0x5a4d;

double randomOf(NodeIndex node, std::uint64_t dimension) {
  return uniformAt(kShardSeed, 8ULL * node + dimension);
}

/// Uniform over all rotations (Shoemake's three numbers).
Eigen::Quaterniond randomRotation(NodeIndex node) {
  const double u = randomOf(node, 0);
  const double v = 2.0 * std::numbers::pi * randomOf(node, 1);
  const double w = 2.0 * std::numbers::pi * randomOf(node, 2);
  return {std::sqrt(1.0 - u) * std::sin(v), std::sqrt(1.0 - u) * std::cos(v), std::sqrt(u) * std::sin(w),
          std::sqrt(u) * std::cos(w)};
}

Vec3 unitOr(const Vec3& vector, const Vec3& fallback) {
  const double length = vector.norm();
  return length > 0.0 && std::isfinite(length) ? Vec3(vector / length) : fallback;
}

Vec3 faceNormal(const std::vector<Vec3>& positions, const std::array<NodeIndex, 4>& nodes) {
  const Vec3 diagonal = positions[nodes[2]] - positions[nodes[0]];
  const Vec3 other = positions[nodes[3]] - positions[nodes[1]];
  return unitOr(diagonal.cross(other), Vec3::UnitZ());
}

/// A cell made of nodes of two materials came about by gluing: the glue bonds keep the material of the part
/// whose cell it was.
MaterialIndex cellMaterial(const Network& network, const CellCorners& cell) {
  const MaterialIndex first = network.nodeMaterials[cell[0]];
  for (const NodeIndex a : cell) {
    if (network.nodeMaterials[a] == first) continue;
    for (const NodeIndex b : cell) {
      if (network.nodeMaterials[b] != first) continue;
      if (const BondIndex glue = network.findBond(a, b); glue != kNone) return network.bond(glue).material;
    }
  }
  return first;
}

PartIndex cellPart(const Network& network, const CellCorners& cell, MaterialIndex material) {
  for (const NodeIndex node : cell) {
    if (network.nodeMaterials[node] == material) return network.nodeParts[node];
  }
  return network.nodeParts[cell[0]];
}

/// Corners of the surface faces, gathered by node. A corner is 4 face + its place in the face.
struct CornersOfNodes {
  std::vector<std::uint32_t> start;
  std::vector<std::uint32_t> corners;
};

CornersOfNodes gatherCorners(std::size_t nodeCount, const std::vector<SurfaceFace>& faces) {
  CornersOfNodes gathered;
  gathered.start.assign(nodeCount + 1, 0);
  for (const SurfaceFace& face : faces) {
    for (const NodeIndex node : face.nodes) ++gathered.start[node + 1];
  }
  std::partial_sum(gathered.start.begin(), gathered.start.end(), gathered.start.begin());
  std::vector<std::uint32_t> end(gathered.start.begin(), gathered.start.end() - 1);
  gathered.corners.resize(faces.size() * 4);
  for (std::uint32_t corner = 0; corner < gathered.corners.size(); ++corner) {
    gathered.corners[end[faces[corner / 4].nodes[corner % 4]]++] = corner;
  }
  return gathered;
}

/// Finds the normals of the outside and broken faces, node by node.
class NormalSmoother {
 public:
  NormalSmoother(const Network& network, const std::vector<Vec3>& positions,
                 const std::vector<SurfaceFace>& faces)
      : positions_(positions), faces_(faces) {
    restNormals_.reserve(faces.size());
    for (const SurfaceFace& face : faces) restNormals_.push_back(faceNormal(network.positions, face.nodes));
  }

  /// Appends the normals of one node to `normals` and notes for each of its corners which is its own.
  void smooth(const std::uint32_t* corners, std::size_t count, std::vector<Vec3>& normals,
              std::vector<std::uint32_t>& normalOfCorner) {
    group(corners, count);
    sums_.assign(count, Vec3::Zero());
    for (std::size_t i = 0; i < count; ++i) sums_[groups_[i]] += weightedNormal(corners[i]);
    for (std::size_t i = 0; i < count; ++i) {
      if (groups_[i] == i) {
        normalOfCorner[corners[i]] = static_cast<std::uint32_t>(normals.size());
        normals.push_back(unitOr(sums_[i], faceNormal(positions_, faces_[corners[i] / 4].nodes)));
      } else {
        normalOfCorner[corners[i]] = normalOfCorner[corners[groups_[i]]];
      }
    }
  }

 private:
  NodeIndex neighbour(std::uint32_t corner, std::uint32_t step) const {
    return faces_[corner / 4].nodes[(corner + step) % 4];
  }

  bool shareNormal(std::uint32_t a, std::uint32_t b) const {
    if (faces_[a / 4].fracture != faces_[b / 4].fracture) return false;
    if (neighbour(a, 1) != neighbour(b, 3) && neighbour(a, 3) != neighbour(b, 1)) return false;
    static const double kCosine = std::cos(SurfaceBuilder::kCreaseAngle * std::numbers::pi / 180.0);
    return restNormals_[a / 4].dot(restNormals_[b / 4]) > kCosine;
  }

  /// groups_[i]: the first corner of those i is joined to, directly or by others.
  void group(const std::uint32_t* corners, std::size_t count) {
    groups_.resize(count);
    std::iota(groups_.begin(), groups_.end(), std::size_t{0});
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (groups_[i] == groups_[j] || !shareNormal(corners[i], corners[j])) continue;
        const auto [kept, dropped] = std::minmax(groups_[i], groups_[j]);
        const std::size_t from = dropped;
        const std::size_t to = kept;
        std::replace(groups_.begin(), groups_.end(), from, to);
      }
    }
  }

  Vec3 weightedNormal(std::uint32_t corner) const {
    const Vec3& here = positions_[neighbour(corner, 0)];
    const Vec3 forward = positions_[neighbour(corner, 1)] - here;
    const Vec3 backward = positions_[neighbour(corner, 3)] - here;
    const Vec3 cross = forward.cross(backward);
    return unitOr(cross, Vec3::Zero()) * std::atan2(cross.norm(), forward.dot(backward));
  }

  const std::vector<Vec3>& positions_;
  const std::vector<SurfaceFace>& faces_;
  std::vector<Vec3> restNormals_;
  std::vector<std::size_t> groups_;
  std::vector<Vec3> sums_;
};

void addCellFaces(const Network& network, const Snapshot& moment, const std::vector<SurfaceFace>& faces,
                  SurfaceMesh& mesh) {
  const CornersOfNodes gathered = gatherCorners(network.nodeCount(), faces);
  NormalSmoother smoother(network, moment.positions, faces);
  std::vector<std::uint32_t> normalOfCorner(faces.size() * 4);
  std::vector<std::uint32_t> pointOfNode(network.nodeCount(), kNone);
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    const std::uint32_t first = gathered.start[node];
    const std::uint32_t last = gathered.start[node + 1];
    if (first == last) continue;
    pointOfNode[node] = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back(moment.positions[node]);
    mesh.restPoints.push_back(network.positions[node]);
    mesh.nodeOfPoint.push_back(node);
    smoother.smooth(&gathered.corners[first], last - first, mesh.normals, normalOfCorner);
  }
  mesh.faces.reserve(faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const CellCorners& cell = network.cells[faces[f].cell];
    SurfaceMesh::Face face;
    for (std::uint32_t c = 0; c < 4; ++c) {
      face.points[c] = pointOfNode[faces[f].nodes[c]];
      face.normals[c] = normalOfCorner[4 * f + c];
    }
    face.inside = faces[f].fracture;
    face.material = cellMaterial(network, cell);
    face.part = cellPart(network, cell, face.material);
    face.fragment = moment.fragmentOfNode[cell[0]];
    face.cell = faces[f].cell;
    mesh.faces.push_back(face);
  }
}

std::vector<std::uint8_t> nodesHeldByAnything(const Network& network, const Snapshot& moment) {
  std::vector<std::uint8_t> held(network.nodeCount(), 0);
  for (CellIndex cell = 0; cell < network.cellCount(); ++cell) {
    if (!moment.brokenCells.empty() && moment.brokenCells[cell] != 0) continue;
    for (const NodeIndex node : network.cells[cell]) held[node] = 1;
  }
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    for (BondIndex bond = network.firstBond[node]; bond < network.firstBond[node + 1]; ++bond) {
      if (!moment.brokenBonds.empty() && moment.brokenBonds[bond] != 0) continue;
      held[node] = 1;
      held[network.bondEnds[bond]] = 1;
    }
  }
  return held;
}

void addShard(const Network& network, const Snapshot& moment, NodeIndex node, SurfaceMesh& mesh) {
  static constexpr std::array<std::array<double, 3>, 4> kCorners{
      {{1.0, 1.0, 1.0}, {-1.0, -1.0, 1.0}, {-1.0, 1.0, -1.0}, {1.0, -1.0, -1.0}}};
  static constexpr std::array<std::array<std::uint32_t, 3>, 4> kSides{
      {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};
  const double reach = SurfaceBuilder::kShardReach * static_cast<double>(network.radii[node]);
  const Eigen::Quaterniond rotation = randomRotation(node);
  const auto firstPoint = static_cast<std::uint32_t>(mesh.points.size());
  for (std::uint32_t i = 0; i < 4; ++i) {
    const Vec3 direction = Vec3(kCorners[i][0], kCorners[i][1], kCorners[i][2]).normalized();
    const double irregular = 0.6 + 0.4 * randomOf(node, 3 + i);
    const Vec3 offset = rotation * (reach * irregular * direction);
    mesh.points.emplace_back(moment.positions[node] + offset);
    mesh.restPoints.emplace_back(network.positions[node] + offset);
    mesh.nodeOfPoint.push_back(node);
  }
  for (const auto& side : kSides) {
    SurfaceMesh::Face face;
    for (std::uint32_t c = 0; c < 4; ++c) face.points[c] = firstPoint + side[std::min(c, 2U)];
    face.normals.fill(static_cast<std::uint32_t>(mesh.normals.size()));
    const Vec3& a = mesh.points[face.points[0]];
    mesh.normals.push_back(
        unitOr((mesh.points[face.points[1]] - a).cross(mesh.points[face.points[2]] - a), Vec3::UnitZ()));
    face.cornerCount = 3;
    face.inside = true;
    face.material = network.nodeMaterials[node];
    face.part = network.nodeParts[node];
    face.fragment = moment.fragmentOfNode[node];
    mesh.faces.push_back(face);
  }
}

}  // namespace

SurfaceBuilder::SurfaceBuilder(const Network& network) : network_(network), cellFaces_(network) {}

SurfaceMesh SurfaceBuilder::build(const Snapshot& moment) const {
  assert(moment.positions.size() == network_.nodeCount());
  assert(moment.fragmentOfNode.size() == network_.nodeCount());
  SurfaceMesh mesh;
  addCellFaces(network_, moment, cellFaces_.surface(moment.brokenCells), mesh);
  const std::vector<std::uint8_t> held = nodesHeldByAnything(network_, moment);
  for (NodeIndex node = 0; node < network_.nodeCount(); ++node) {
    if (held[node] == 0) addShard(network_, moment, node, mesh);
  }
  std::stable_sort(mesh.faces.begin(), mesh.faces.end(),
                   [](const auto& a, const auto& b) { return a.fragment < b.fragment; });
  return mesh;
}

Snapshot momentAtRest(const Network& network) {
  Snapshot moment;
  moment.positions = network.positions;
  moment.velocities = network.velocities;
  moment.brokenBonds.assign(network.bondCount(), 0);
  moment.brokenCells.assign(network.cellCount(), 0);
  moment.fragmentOfNode.resize(network.nodeCount());
  std::vector<NodeIndex> root(network.nodeCount());
  std::iota(root.begin(), root.end(), NodeIndex{0});
  const auto find = [&root](NodeIndex node) {
    while (root[node] != node) node = root[node] = root[root[node]];
    return node;
  };
  const auto join = [&](NodeIndex a, NodeIndex b) {
    const auto [low, high] = std::minmax({find(a), find(b)});
    root[high] = low;
  };
  for (NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (BondIndex bond = network.firstBond[a]; bond < network.firstBond[a + 1]; ++bond) {
      join(a, network.bondEnds[bond]);
    }
  }
  FragmentId next = 0;
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    const NodeIndex first = find(node);
    moment.fragmentOfNode[node] = first == node ? next++ : moment.fragmentOfNode[first];
  }
  return moment;
}

}  // namespace sim
