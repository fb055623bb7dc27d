#include "ui/viewport/topology.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/base/parallel.h"

namespace ui {
namespace {

Eigen::Vector3f pointAt(const std::vector<std::array<float, 4>>& positions, sim::NodeIndex node) {
  return Eigen::Map<const Eigen::Vector3f>(positions[node].data());
}

bool isHidden(const std::vector<std::uint8_t>& hidden, sim::PartIndex part) {
  return part < hidden.size() && hidden[part] != 0;
}

/// Faces in the order in which they are drawn: part by part.
std::vector<std::uint32_t> facesByPart(const sim::SurfaceTopology& mesh,
                                       const std::vector<std::uint8_t>& hidden, bool loose) {
  std::vector<std::uint32_t> order;
  const bool anyHidden = std::any_of(hidden.begin(), hidden.end(), [](std::uint8_t is) { return is != 0; });
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const sim::SurfaceMesh::Face& face = mesh.faces[f];
    if (face.covered && !anyHidden) continue;
    if ((face.cell == sim::kNone) == loose && !isHidden(hidden, face.part)) order.push_back(f);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return mesh.faces[a].part < mesh.faces[b].part; });
  return order;
}

void extendRange(std::vector<TopologyDraw::Range>& ranges, sim::PartIndex part, std::uint32_t at,
                 std::uint32_t count) {
  if (ranges.empty() || ranges.back().part != part) ranges.push_back({part, at, 0});
  ranges.back().count += count;
}

/// Gathers the corners of each normal of the mesh that is drawn.
void gatherNormals(const std::vector<std::uint32_t>& normalOfCorner, std::size_t normalCount,
                   TopologyDraw& topology) {
  std::vector<std::uint32_t>& first = topology.firstOfNormal;
  first.assign(normalCount + 1, 0);
  for (const std::uint32_t normal : normalOfCorner) ++first[normal + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> end(first.begin(), first.end() - 1);
  topology.cornersOfNormal.resize(normalOfCorner.size());
  for (std::uint32_t corner = 0; corner < normalOfCorner.size(); ++corner)
    topology.cornersOfNormal[end[normalOfCorner[corner]]++] = corner;
}

/// Of each point of the surface, its place among the positions: its node, or behind all nodes.
std::vector<std::uint32_t> placesOfPoints(const sim::Network& network, TopologyDraw& topology) {
  const sim::SurfaceTopology& mesh = topology.surface;
  std::vector<std::uint32_t> places(mesh.pointCount());
  for (std::uint32_t point = 0; point < places.size(); ++point) {
    const bool atNode = mesh.firstAnchor[point] == mesh.firstAnchor[point + 1];
    places[point] = atNode ? mesh.nodeOfPoint[point]
                           : static_cast<std::uint32_t>(network.nodeCount() + topology.hungPoints.size());
    if (!atNode) topology.hungPoints.push_back(point);
  }
  return places;
}

void addFaces(const sim::Network& network, const std::vector<std::uint8_t>& hidden, TopologyDraw& topology) {
  const sim::SurfaceTopology& mesh = topology.surface;
  const std::vector<std::uint32_t> order = facesByPart(mesh, hidden, false);
  const std::vector<std::uint32_t> places = placesOfPoints(network, topology);
  std::vector<std::uint32_t> normalOfCorner;
  topology.faces.reserve(order.size());
  topology.cornerNodes.reserve(4 * order.size());
  topology.indices.reserve(6 * order.size());
  normalOfCorner.reserve(4 * order.size());
  for (const std::uint32_t f : order) {
    const sim::SurfaceMeshFace& from = mesh.faces[f];
    const auto index = static_cast<std::uint32_t>(topology.faces.size());
    DrawnFace face{{}, from.cell, from.fragment, from.part, from.material, from.inside};
    for (std::size_t c = 0; c < 4; ++c) {
      face.nodes[c] = mesh.nodeOfPoint[from.points[c]];
      topology.cornerNodes.push_back(places[from.points[c]]);
      normalOfCorner.push_back(from.normals[c]);
    }
    for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U})
      topology.indices.push_back(4 * index + corner);
    extendRange(topology.partFaces, face.part, index, 1);
    topology.faces.push_back(face);
  }
  gatherNormals(normalOfCorner, mesh.normalCount(), topology);
}

void addShards(const sim::Network& network, const std::vector<std::uint8_t>& hidden, TopologyDraw& topology) {
  const sim::SurfaceTopology& mesh = topology.surface;
  const std::vector<sim::Vec3> normals = sim::placeNormals(mesh, mesh.restPoints);
  for (const std::uint32_t f : facesByPart(mesh, hidden, true)) {
    const sim::SurfaceMeshFace& face = mesh.faces[f];
    extendRange(topology.partShards, face.part, static_cast<std::uint32_t>(topology.shards.size()), 3);
    const sim::NodeIndex node = mesh.nodeOfPoint[face.points[0]];
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Vector3f offset =
          (mesh.restPoints[face.points[c]] - network.positions[node]).cast<float>();
      topology.shards.push_back(
          {node, {offset.x(), offset.y(), offset.z()}, packNormal(normals[face.normals[c]])});
    }
  }
}

std::vector<std::uint8_t> flagsOf(const sim::Network& network, const sim::Broken& broken,
                                  const std::vector<std::uint8_t>& hidden) {
  std::vector<std::uint8_t> flags(network.bondCount(), kBondIntact);
  for (sim::NodeIndex node = 0; node < network.nodeCount(); ++node) {
    for (sim::BondIndex bond = network.firstBond[node]; bond < network.firstBond[node + 1]; ++bond) {
      const sim::PartIndex part = network.nodeParts[node];
      const sim::PartIndex otherPart = network.nodeParts[network.bondEnds[bond]];
      if (isHidden(hidden, part) || isHidden(hidden, otherPart)) flags[bond] = kBondHidden;
      if (broken.hasLostBond(bond)) flags[bond] |= kBondBroken;
      if (part != otherPart) flags[bond] |= kBondGlue;
    }
  }
  return flags;
}

Eigen::Vector3f weightedNormal(const TopologyDraw& topology,
                               const std::vector<std::array<float, 4>>& positions, std::uint32_t corner) {
  const std::uint32_t face = corner & ~3U;
  const auto nodeAt = [&](std::uint32_t step) { return topology.cornerNodes[face + (corner + step) % 4]; };
  const std::uint32_t own = nodeAt(0);
  const Eigen::Vector3f here = pointAt(positions, own);
  // A triangle has its third corner twice.
  const Eigen::Vector3f forward = pointAt(positions, nodeAt(1) == own ? nodeAt(2) : nodeAt(1)) - here;
  const Eigen::Vector3f backward = pointAt(positions, nodeAt(3) == own ? nodeAt(2) : nodeAt(3)) - here;
  const Eigen::Vector3f cross = forward.cross(backward);
  const float length = cross.norm();
  if (!(length > 0.0F)) return Eigen::Vector3f::Zero();
  return cross * (std::atan2(length, forward.dot(backward)) / length);
}

}  // namespace

std::uint32_t packNormal(const sim::Vec3& unit) {
  std::uint32_t result = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto step = static_cast<std::int32_t>(std::lround(511.0 * std::clamp(unit[axis], -1.0, 1.0)));
    result |= (static_cast<std::uint32_t>(step) & 0x3ffU) << (10U * static_cast<std::uint32_t>(axis));
  }
  return result;
}

sim::Vec3 unpackNormal(std::uint32_t packed) {
  sim::Vec3 normal;
  for (int axis = 0; axis < 3; ++axis) {
    // Shifted to the top and back, so that the sign fills the bits above.
    const auto bits = static_cast<std::int32_t>(packed << (22U - 10U * static_cast<std::uint32_t>(axis)));
    normal[axis] = static_cast<double>(bits >> 22) / 511.0;
  }
  return normal;
}

TopologyDraw topologyOf(const sim::Network& network, sim::SurfaceBuilder& surface,
                        const sim::BrokenPointer& broken, const std::vector<std::uint8_t>& hidden) {
  TopologyDraw topology;
  topology.surface = surface.topology(broken);
  addFaces(network, hidden, topology);
  addShards(network, hidden, topology);
  topology.bondFlags = flagsOf(network, *broken, hidden);
  return topology;
}

std::vector<std::array<float, 4>> cornerPositions(const TopologyDraw& topology,
                                                  const std::vector<sim::Vec3>& nodePositions) {
  std::vector<std::array<float, 4>> positions;
  positions.reserve(nodePositions.size() + topology.hungPoints.size());
  const auto add = [&](const sim::Vec3& at) {
    const Eigen::Vector3f position = at.cast<float>();
    positions.push_back({position.x(), position.y(), position.z(), 1.0F});
  };
  for (const sim::Vec3& at : nodePositions) add(at);
  if (topology.hungPoints.empty()) return positions;
  const std::vector<sim::Vec3> points = sim::placePoints(topology.surface, nodePositions);
  for (const std::uint32_t point : topology.hungPoints) add(points[point]);
  return positions;
}

std::vector<std::uint32_t> cornerNormals(const TopologyDraw& topology,
                                         const std::vector<std::array<float, 4>>& positions) {
  std::vector<std::uint32_t> normals(topology.cornerNodes.size());
  const std::size_t count = topology.firstOfNormal.empty() ? 0 : topology.firstOfNormal.size() - 1;
  sim::parallelRanges(count, 1024, sim::Sharing::balanced, [&](std::size_t begin, std::size_t end) {
    for (std::size_t normal = begin; normal != end; ++normal) {
      const std::uint32_t* const first = topology.cornersOfNormal.data() + topology.firstOfNormal[normal];
      const std::uint32_t* const last =
          first + (topology.firstOfNormal[normal + 1] - topology.firstOfNormal[normal]);
      Eigen::Vector3f sum = Eigen::Vector3f::Zero();
      for (const std::uint32_t* corner = first; corner != last; ++corner)
        sum += weightedNormal(topology, positions, *corner);
      const float length = sum.norm();
      const std::uint32_t packedNormal =
          packNormal(length > 0.0F ? sim::Vec3((sum / length).cast<double>()) : sim::Vec3::UnitZ());
      for (const std::uint32_t* corner = first; corner != last; ++corner) normals[*corner] = packedNormal;
    }
  });
  return normals;
}

}  // namespace ui
