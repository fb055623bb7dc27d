#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "sim/network/network.h"

/// Wedges: cells of which gluing made neighbouring corners one node. Such a cell names that node at each of
/// these corners; sides that lost one corner are triangles, those that lost two are none.
namespace sim {

/// The nodes of a cell, each once, in order of their first corners.
class DistinctCorners {
 public:
  explicit DistinctCorners(const CellCorners& corners) {
    for (const NodeIndex node : corners) {
      if (std::find(begin(), end(), node) == end()) nodes_[count_++] = node;
    }
  }
  const NodeIndex* begin() const { return nodes_.data(); }
  const NodeIndex* end() const { return nodes_.data() + count_; }
  std::size_t size() const { return count_; }
  NodeIndex operator[](std::size_t place) const { return nodes_[place]; }

 private:
  std::array<NodeIndex, 8> nodes_{};
  std::uint8_t count_ = 0;
};

/// The nodes around a side of a cell, counter-clockwise seen from outside. A triangle repeats its third as
/// the fourth; a side of fewer nodes has collapsed to an edge or a point.
struct SideNodes {
  std::array<NodeIndex, 4> nodes{};
  std::uint8_t distinct = 4;

  bool isTriangle() const { return distinct == 3; }
  bool hasCollapsed() const { return distinct < 3; }
};
SideNodes sideNodes(const CellCorners& cell, std::uint32_t side);

/// Whether the corners that are one node hang together along edges of the cell, around every side too, and at
/// least four nodes are left: then the sides which have not collapsed are one closed surface.
bool isProperWedge(const CellCorners& cell);

inline bool isWedge(const CellCorners& cell) {
  return DistinctCorners(cell).size() < cell.size();
}

}  // namespace sim
