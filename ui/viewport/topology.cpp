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
std::vector<std::uint32_t> facesByPart(const sim::SurfaceMesh& mesh, const std::vector<std::uint8_t>& hidden,
                                       std::uint8_t cornerCount) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t f = 0; f < mesh.faces.size(); ++f) {
    const sim::SurfaceMesh::Face& face = mesh.faces[f];
    if (face.cornerCount == cornerCount && !isHidden(hidden, face.part)) order.push_back(f);
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

void addFaces(const sim::SurfaceMesh& mesh, const std::vector<std::uint8_t>& hidden, TopologyDraw& topology) {
  const std::vector<std::uint32_t> order = facesByPart(mesh, hidden, 4);
  std::vector<std::uint32_t> normalOfCorner;
  topology.faces.reserve(order.size());
  topology.cornerNodes.reserve(4 * order.size());
  topology.indices.reserve(6 * order.size());
  normalOfCorner.reserve(4 * order.size());
  for (const std::uint32_t f : order) {
    const sim::SurfaceMesh::Face& from = mesh.faces[f];
    const auto index = static_cast<std::uint32_t>(topology.faces.size());
    DrawnFace face{{}, from.cell, from.fragment, from.part, from.material, from.inside};
    for (std::size_t c = 0; c < 4; ++c) {
      face.nodes[c] = mesh.nodeOfPoint[from.points[c]];
      topology.cornerNodes.push_back(face.nodes[c]);
      normalOfCorner.push_back(from.normals[c]);
    }
    for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U})
      topology.indices.push_back(4 * index + corner);
    extendRange(topology.partFaces, face.part, index, 1);
    topology.faces.push_back(face);
  }
  gatherNormals(normalOfCorner, mesh.normals.size(), topology);
}

void addShards(const sim::SurfaceMesh& mesh, const sim::Snapshot& moment,
               const std::vector<std::uint8_t>& hidden, TopologyDraw& topology) {
  for (const std::uint32_t f : facesByPart(mesh, hidden, 3)) {
    const sim::SurfaceMesh::Face& face = mesh.faces[f];
    extendRange(topology.partShards, face.part, static_cast<std::uint32_t>(topology.shards.size()), 3);
    const sim::NodeIndex node = mesh.nodeOfPoint[face.points[0]];
    if (topology.isolated.empty() || topology.isolated.back() != node) topology.isolated.push_back(node);
    for (std::size_t c = 0; c < 3; ++c) {
      const Eigen::Vector3f offset = (mesh.points[face.points[c]] - moment.positions[node]).cast<float>();
      topology.shards.push_back(
          {node, {offset.x(), offset.y(), offset.z()}, packNormal(mesh.normals[face.normals[c]])});
    }
  }
}

std::vector<std::uint8_t> flagsOf(const sim::Network& network, const sim::Snapshot& moment,
                                  const std::vector<std::uint8_t>& hidden) {
  std::vector<std::uint8_t> flags(network.bondCount(), kBondIntact);
  for (sim::NodeIndex node = 0; node < network.nodeCount(); ++node) {
    for (sim::BondIndex bond = network.firstBond[node]; bond < network.firstBond[node + 1]; ++bond) {
      const sim::PartIndex part = network.nodeParts[node];
      const sim::PartIndex otherPart = network.nodeParts[network.bondEnds[bond]];
      if (isHidden(hidden, part) || isHidden(hidden, otherPart)) flags[bond] = kBondHidden;
      if (!moment.brokenBonds.empty() && moment.brokenBonds[bond] != 0) flags[bond] |= kBondBroken;
      if (part != otherPart) flags[bond] |= kBondGlue;
    }
  }
  return flags;
}

Eigen::Vector3f weightedNormal(const TopologyDraw& topology,
                               const std::vector<std::array<float, 4>>& positions, std::uint32_t corner) {
  const std::uint32_t face = corner & ~3U;
  const Eigen::Vector3f here = pointAt(positions, topology.cornerNodes[corner]);
  const Eigen::Vector3f forward = pointAt(positions, topology.cornerNodes[face + (corner + 1) % 4]) - here;
  const Eigen::Vector3f backward = pointAt(positions, topology.cornerNodes[face + (corner + 3) % 4]) - here;
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

TopologyDraw topologyOf(const sim::Network& network, const sim::SurfaceBuilder& surface,
                        const sim::Snapshot& moment, const std::vector<std::uint8_t>& hidden) {
  TopologyDraw topology;
  const sim::SurfaceMesh mesh = surface.build(moment);
  addFaces(mesh, hidden, topology);
  addShards(mesh, moment, hidden, topology);
  topology.bondFlags = flagsOf(network, moment, hidden);
  return topology;
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
