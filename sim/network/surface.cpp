#include "sim/network/surface.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace sim {

namespace {

constexpr std::uint32_t kSides = 6;

/// Corners of a cell's sides (corner c = i + 2 j + 4 k), counter-clockwise seen from outside the cell.
constexpr std::array<std::array<std::uint8_t, 4>, kSides> kSideCorners{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

using Quad = std::array<NodeIndex, 4>;

Quad sideNodes(const CellCorners& cell, std::uint32_t side) {
  const auto& corners = kSideCorners[side];
  return {cell[corners[0]], cell[corners[1]], cell[corners[2]], cell[corners[3]]};
}

Quad sortedQuad(const CellCorners& cell, std::uint32_t side) {
  Quad quad = sideNodes(cell, side);
  std::sort(quad.begin(), quad.end());
  return quad;
}

}  // namespace

// Faces are gathered by their lowest node. A node bounds the faces of a handful of cells, so that the
// comparison of all pairs in its bucket costs less than a hash table and needs no random order.
CellFaces::CellFaces(const Network& network) : cells_(network.cells), twins_(cells_.size() * kSides) {
  const auto faceCount = static_cast<std::uint32_t>(twins_.size());
  std::vector<Quad> quads(faceCount);
  std::vector<std::uint32_t> bucketStart(network.nodeCount() + 1, 0);
  for (std::uint32_t face = 0; face < faceCount; ++face) {
    quads[face] = sortedQuad(cells_[face / kSides], face % kSides);
    ++bucketStart[quads[face][0] + 1];
  }
  std::partial_sum(bucketStart.begin(), bucketStart.end(), bucketStart.begin());

  std::vector<std::uint32_t> bucketEnd(bucketStart.begin(), bucketStart.end() - 1);
  std::vector<std::uint32_t> bucketed(faceCount);
  for (std::uint32_t face = 0; face < faceCount; ++face) {
    twins_[face] = face;
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

bool CellFaces::isInterior(std::uint32_t face, const std::vector<std::uint8_t>& brokenCells) const {
  for (std::uint32_t twin = twins_[face]; twin != face; twin = twins_[twin]) {
    if (brokenCells.empty() || brokenCells[twin / kSides] == 0) return true;
  }
  return false;
}

std::vector<SurfaceFace> CellFaces::surface(const std::vector<std::uint8_t>& brokenCells) const {
  assert(brokenCells.empty() || brokenCells.size() == cells_.size());
  std::vector<SurfaceFace> faces;
  for (std::uint32_t face = 0; face < twins_.size(); ++face) {
    const CellIndex cell = face / kSides;
    if (!brokenCells.empty() && brokenCells[cell] != 0) continue;
    if (isInterior(face, brokenCells)) continue;
    faces.push_back({sideNodes(cells_[cell], face % kSides), cell, twins_[face] != face});
  }
  return faces;
}

std::vector<SurfaceFace> surfaceFaces(const Network& network, const std::vector<std::uint8_t>& brokenCells) {
  return CellFaces(network).surface(brokenCells);
}

}  // namespace sim
