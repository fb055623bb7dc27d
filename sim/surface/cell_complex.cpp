#include "sim/surface/cell_complex.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace sim {

namespace {

/// Where the ends of a side of a face are one node.
bool isNoSide(const SideNodes& face, std::uint8_t side) {
  return face.nodes[side] == face.nodes[(side + 1U) % 4];
}

}  // namespace

CellComplex::CellComplex(const Network& network) : network_(network) {
  findTwins();
  listCellsOfNodes();
  listOutside();
  findBodies();
  findParts();
}

std::uint32_t CellComplex::outsidePlace(std::uint32_t face) const {
  if (twins_[face] != face) return kNone;
  const auto found = std::lower_bound(outsideFaces_.begin(), outsideFaces_.end(), face);
  if (found == outsideFaces_.end() || *found != face) return kNone;
  return static_cast<std::uint32_t>(found - outsideFaces_.begin());
}

std::span<const CellComplex::OutsideEdge> CellComplex::outsideEdges(NodeIndex a, NodeIndex b) const {
  const auto [low, high] = std::minmax(a, b);
  const OutsideEdge wanted{low, high, 0, 0};
  const auto range = std::equal_range(
      outsideEdges_.begin(), outsideEdges_.end(), wanted,
      [](const auto& x, const auto& y) { return std::tie(x.low, x.high) < std::tie(y.low, y.high); });
  return {range.first, range.second};
}

// Faces are gathered by their lowest node. A node bounds the faces of a handful of cells, so that the
// comparison of all pairs in its bucket costs less than a hash table and needs no random order.
void CellComplex::findTwins() {
  const auto faceCount = static_cast<std::uint32_t>(network_.cellCount() * kCellSides);
  twins_.resize(faceCount);
  std::vector<std::array<NodeIndex, 4>> quads(faceCount);
  std::vector<std::uint32_t> bucketStart(network_.nodeCount() + 1, 0);
  for (std::uint32_t face = 0; face < faceCount; ++face) {
    twins_[face] = face;
    const SideNodes nodes = nodesOf(face);
    quads[face] = nodes.nodes;
    // Which of a triangle's nodes stands twice is chance.
    if (nodes.isTriangle()) quads[face][3] = kNone;
    std::sort(quads[face].begin(), quads[face].end());
    ++bucketStart[quads[face][0] + 1];
  }
  std::partial_sum(bucketStart.begin(), bucketStart.end(), bucketStart.begin());

  std::vector<std::uint32_t> bucketEnd(bucketStart.begin(), bucketStart.end() - 1);
  std::vector<std::uint32_t> bucketed(faceCount);
  for (std::uint32_t face = 0; face < faceCount; ++face) {
    if (nodesOf(face).hasCollapsed()) continue;
    std::uint32_t& end = bucketEnd[quads[face][0]];
    for (std::uint32_t slot = bucketStart[quads[face][0]]; slot < end; ++slot) {
      const std::uint32_t other = bucketed[slot];
      if (quads[other] == quads[face]) {
        std::swap(twins_[face], twins_[other]);
        break;
      }
    }
    bucketed[end++] = face;
  }
}

void CellComplex::listCellsOfNodes() {
  firstCell_.assign(network_.nodeCount() + 1, 0);
  for (const CellCorners& cell : network_.cells) {
    for (const NodeIndex node : DistinctCorners(cell)) ++firstCell_[node + 1];
  }
  std::partial_sum(firstCell_.begin(), firstCell_.end(), firstCell_.begin());
  cellsOfNode_.resize(firstCell_.back());
  std::vector<std::uint32_t> next(firstCell_.begin(), firstCell_.end() - 1);
  for (CellIndex cell = 0; cell < network_.cellCount(); ++cell) {
    for (const NodeIndex node : DistinctCorners(network_.cells[cell])) cellsOfNode_[next[node]++] = cell;
  }
}

void CellComplex::listOutside() {
  for (std::uint32_t face = 0; face < twins_.size(); ++face) {
    if (twins_[face] != face) continue;
    const SideNodes nodes = nodesOf(face);
    if (nodes.hasCollapsed()) continue;
    for (std::uint8_t side = 0; side < 4; ++side) {
      if (isNoSide(nodes, side)) continue;
      const auto [low, high] = std::minmax(nodes.nodes[side], nodes.nodes[(side + 1U) % 4]);
      outsideEdges_.push_back({low, high, static_cast<std::uint32_t>(outsideFaces_.size()), side});
    }
    outsideFaces_.push_back(face);
  }
  std::stable_sort(outsideEdges_.begin(), outsideEdges_.end(), [](const auto& x, const auto& y) {
    return std::tie(x.low, x.high) < std::tie(y.low, y.high);
  });
}

void CellComplex::findBodies() {
  std::vector<std::uint32_t> bodyOfNode(network_.nodeCount(), kNone);
  std::vector<NodeIndex> reached;
  for (NodeIndex first = 0; first < network_.nodeCount(); ++first) {
    if (cellsOf(first).empty()) bareNodes_.push_back(first);
    if (bodyOfNode[first] != kNone || cellsOf(first).empty()) continue;
    const auto body = static_cast<std::uint32_t>(bodies_.size());
    bodies_.emplace_back();
    reached = {first};
    bodyOfNode[first] = body;
    while (!reached.empty()) {
      const NodeIndex node = reached.back();
      reached.pop_back();
      for (const CellIndex cell : cellsOf(node)) {
        for (const NodeIndex other : network_.cells[cell]) {
          if (bodyOfNode[other] != kNone) continue;
          bodyOfNode[other] = body;
          reached.push_back(other);
        }
      }
    }
  }
  for (NodeIndex node = 0; node < network_.nodeCount(); ++node) {
    if (bodyOfNode[node] != kNone) bodies_[bodyOfNode[node]].nodes.push_back(node);
  }
  for (CellIndex cell = 0; cell < network_.cellCount(); ++cell)
    bodies_[bodyOfNode[network_.cells[cell][0]]].cells.push_back(cell);
  for (std::uint32_t place = 0; place < outsideFaces_.size(); ++place) {
    const CellIndex cell = outsideFaces_[place] / kCellSides;
    bodies_[bodyOfNode[network_.cells[cell][0]]].outsideFaces.push_back(place);
  }
}

MaterialIndex CellComplex::materialOf(CellIndex cell) const {
  const CellCorners& corners = network_.cells[cell];
  const MaterialIndex first = network_.nodeMaterials[corners[0]];
  for (const NodeIndex a : corners) {
    if (network_.nodeMaterials[a] == first) continue;
    for (const NodeIndex b : corners) {
      if (network_.nodeMaterials[b] != first) continue;
      if (const BondIndex glue = network_.findBond(a, b); glue != kNone) return network_.bond(glue).material;
    }
  }
  return first;
}

// Cells stand in the order of their parts, so that a part of a cell's nodes is its own if it is none before
// that of the last cell with nodes of one part only, and none after that of the next. Where two are left, the
// one of the cell's material is taken.
void CellComplex::findParts() {
  const auto partsOf = [&](CellIndex cell) {
    std::array<PartIndex, kCellCorners> parts{};
    for (std::size_t c = 0; c < kCellCorners; ++c) parts[c] = network_.nodeParts[network_.cells[cell][c]];
    return parts;
  };
  const auto count = static_cast<CellIndex>(network_.cellCount());
  parts_.assign(count, 0);
  std::vector<PartIndex> latest(count);
  PartIndex next = std::numeric_limits<PartIndex>::max();
  for (CellIndex cell = count; cell-- > 0;) {
    const auto parts = partsOf(cell);
    if (std::all_of(parts.begin(), parts.end(), [&](PartIndex part) { return part == parts[0]; }))
      next = parts[0];
    latest[cell] = next;
  }
  PartIndex earliest = 0;
  for (CellIndex cell = 0; cell < count; ++cell) {
    const auto parts = partsOf(cell);
    const MaterialIndex material = materialOf(cell);
    bool found = false;
    for (std::size_t c = 0; c < kCellCorners; ++c) {
      if (parts[c] < earliest || parts[c] > latest[cell]) continue;
      const bool fits = network_.nodeMaterials[network_.cells[cell][c]] == material;
      if (!found || fits) parts_[cell] = parts[c];
      found = true;
      if (fits) break;
    }
    if (!found) parts_[cell] = parts[0];
    if (std::all_of(parts.begin(), parts.end(), [&](PartIndex part) { return part == parts[0]; }))
      earliest = parts[0];
  }
}

bool CellComplex::isCovered(std::uint32_t face) const {
  const auto& nodes = nodesOf(face).nodes;
  const PartIndex other = network_.nodeParts[nodes[0]];
  return other != partOf(face / kCellSides) && std::all_of(nodes.begin(), nodes.end(), [&](NodeIndex node) {
           return network_.nodeParts[node] == other;
         });
}

}  // namespace sim
