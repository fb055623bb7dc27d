#include "sim/contact/outside.h"

#include <algorithm>
#include <tuple>

#include "sim/network/cell_shape.h"

namespace sim {
namespace {

/// A side of a cell, known by its corners whatever their order.
struct Side {
  std::array<NodeIndex, 4> sorted;
  CellIndex cell;
  std::uint8_t index;
};

std::vector<Side> sidesOf(const Network& network, const std::vector<std::uint8_t>& brokenCells) {
  std::vector<Side> sides;
  sides.reserve(kCellSides * network.cellCount());
  for (CellIndex cell = 0; cell < network.cellCount(); ++cell) {
    if (!brokenCells.empty() && brokenCells[cell] != 0) continue;
    for (std::uint8_t side = 0; side < kCellSides; ++side) {
      Side each{{}, cell, side};
      for (std::size_t i = 0; i < 4; ++i) each.sorted[i] = network.cells[cell][kSideCorners[side][i]];
      std::ranges::sort(each.sorted);
      sides.push_back(each);
    }
  }
  std::ranges::sort(sides, [](const Side& left, const Side& right) {
    if (left.sorted != right.sorted) return left.sorted < right.sorted;
    return left.cell < right.cell;
  });
  return sides;
}

/// The corners in order, without those that a wedge names twice.
std::vector<NodeIndex> cornersOf(const Network& network, const Side& side) {
  std::vector<NodeIndex> corners;
  for (const std::uint8_t corner : kSideCorners[side.index]) {
    const NodeIndex node = network.cells[side.cell][corner];
    if (std::ranges::find(corners, node) == corners.end()) corners.push_back(node);
  }
  return corners;
}

}  // namespace

Vec3 normalOf(const OutsideTriangle& triangle, const NodeVectors& positions) {
  const Vec3 a = positions.get(triangle.nodes[0]);
  return (positions.get(triangle.nodes[1]) - a).cross(positions.get(triangle.nodes[2]) - a).normalized();
}

Outside::Outside(const Network& network) : network_(&network) {
  find();
}

void Outside::follow(const Breakage& breakage) {
  if (breakage.brokenCellCount() == brokenCount_) return;
  brokenCount_ = breakage.brokenCellCount();
  brokenCells_ = breakage.brokenCells();
  find();
}

void Outside::takeOver(const Outside& other) {
  brokenCells_ = other.brokenCells_;
  brokenCount_ = other.brokenCount_;
  find();
}

void Outside::save(ByteWriter& writer) const {
  writer.putVector(brokenCells_);
}

bool Outside::load(ByteReader& reader) {
  if (!reader.readVector(brokenCells_) ||
      (!brokenCells_.empty() && brokenCells_.size() != network_->cellCount()))
    return false;
  brokenCount_ = static_cast<std::uint64_t>(
      std::ranges::count_if(brokenCells_, [](std::uint8_t cell) { return cell != 0; }));
  find();
  return true;
}

void Outside::find() {
  triangles_.clear();
  loose_.assign(network_->nodeCount(), 1);
  const std::vector<Side> sides = sidesOf(*network_, brokenCells_);
  for (const Side& side : sides) {
    for (const NodeIndex node : side.sorted) loose_[node] = 0;
  }
  for (std::size_t s = 0; s < sides.size();) {
    std::size_t end = s + 1;
    while (end < sides.size() && sides[end].sorted == sides[s].sorted) ++end;
    if (end == s + 1) {
      const std::vector<NodeIndex> corners = cornersOf(*network_, sides[s]);
      if (corners.size() >= 3) {
        // The diagonal begins at the least node, so that it does not depend on how the cell names its
        // corners.
        std::size_t least = 0;
        for (std::size_t i = 1; i < corners.size(); ++i) least = corners[i] < corners[least] ? i : least;
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
          triangles_.push_back({{corners[least], corners[(least + i) % corners.size()],
                                 corners[(least + i + 1) % corners.size()]},
                                sides[s].cell});
        }
      }
    }
    s = end;
  }
  join();
}

void Outside::join() {
  struct Half {
    NodeIndex low, high;
    CellIndex cell;
    std::uint32_t triangle;
  };
  std::vector<Half> halves;
  halves.reserve(3 * triangles_.size());
  firstTriangle_.assign(network_->nodeCount() + 1, 0);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const OutsideTriangle& triangle = triangles_[t];
    for (std::uint8_t i = 0; i < 3; ++i) {
      const NodeIndex a = triangle.nodes[i];
      const NodeIndex b = triangle.nodes[(i + 1U) % 3U];
      halves.push_back({std::min(a, b), std::max(a, b), triangle.cell, t});
      ++firstTriangle_[a + 1];
    }
  }
  for (std::size_t n = 0; n < network_->nodeCount(); ++n) firstTriangle_[n + 1] += firstTriangle_[n];
  trianglesOfNode_.resize(halves.size());
  std::vector<std::uint32_t> next(firstTriangle_.begin(), firstTriangle_.end() - 1);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    for (const NodeIndex node : triangles_[t].nodes) trianglesOfNode_[next[node]++] = t;
  }
  std::ranges::sort(halves, [](const Half& left, const Half& right) {
    return std::tie(left.low, left.high, left.cell, left.triangle) <
           std::tie(right.low, right.high, right.cell, right.triangle);
  });
  edges_.clear();
  const auto pair = [&](const Half& one, const Half& two) {
    edges_.push_back({{one.low, one.high}, {one.triangle, two.triangle}});
  };
  for (std::size_t h = 0; h < halves.size();) {
    std::size_t end = h + 1;
    while (end < halves.size() && halves[end].low == halves[h].low && halves[end].high == halves[h].high)
      ++end;
    // Where cells meet in an edge only, each keeps to its own two sides.
    std::vector<Half> left;
    for (std::size_t i = h; i < end; ++i) {
      if (i + 1 < end && end - h > 2 && halves[i].cell == halves[i + 1].cell) {
        pair(halves[i], halves[i + 1]);
        ++i;
      } else {
        left.push_back(halves[i]);
      }
    }
    for (std::size_t i = 0; i + 1 < left.size(); i += 2) pair(left[i], left[i + 1]);
    h = end;
  }
}

std::size_t Outside::memoryBytes() const {
  const auto bytes = [](const auto& vector) { return vector.capacity() * sizeof(vector[0]); };
  return bytes(brokenCells_) + bytes(triangles_) + bytes(edges_) + bytes(firstTriangle_) +
         bytes(trianglesOfNode_) + bytes(loose_);
}

}  // namespace sim
