#include "sim/network/wedge.h"

#include <numeric>

#include "sim/network/cell_shape.h"

namespace sim {

SideNodes sideNodes(const CellCorners& cell, std::uint32_t side) {
  const auto& corners = kSideCorners[side];
  const std::array<NodeIndex, 4> all{cell[corners[0]], cell[corners[1]], cell[corners[2]], cell[corners[3]]};
  std::array<NodeIndex, 4> kept{};
  std::uint8_t count = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    if (all[c] != all[(c + 1) % 4]) kept[count++] = all[c];
  }
  SideNodes found{all, count};
  if (count == 3) found.nodes = {kept[0], kept[1], kept[2], kept[2]};
  return found;
}

bool isProperWedge(const CellCorners& cell) {
  const DistinctCorners distinct(cell);
  if (distinct.size() < 4) return false;
  std::array<std::uint8_t, 8> group{};
  std::iota(group.begin(), group.end(), std::uint8_t{0});
  std::size_t groups = cell.size();
  for (const CellEdge& edge : kCellEdges) {
    if (cell[edge.low] != cell[edge.high] || group[edge.low] == group[edge.high]) continue;
    const std::uint8_t from = group[edge.high], to = group[edge.low];
    std::replace(group.begin(), group.end(), from, to);
    --groups;
  }
  if (groups != distinct.size()) return false;
  for (const auto& side : kSideCorners) {
    for (std::size_t c = 0; c < 2; ++c) {
      const NodeIndex node = cell[side[c]];
      if (node == cell[side[c + 2]] && node != cell[side[c + 1]] && node != cell[side[(c + 3) % 4]])
        return false;
    }
  }
  return true;
}

}  // namespace sim
