#include "sim/contact/outside.h"

#include <algorithm>
#include <tuple>

#include "sim/network/cell_shape.h"

namespace sim {
namespace {

/// The corners of a side in order, without those that a wedge names twice.
struct Corners {
  std::array<NodeIndex, 4> nodes{};
  std::size_t count = 0;
};

Corners cornersOf(const Network& network, CellIndex cell, std::uint8_t side) {
  Corners corners;
  for (const std::uint8_t corner : kSideCorners[side]) {
    const NodeIndex node = network.cells[cell][corner];
    const auto end = corners.nodes.begin() + static_cast<std::ptrdiff_t>(corners.count);
    if (std::find(corners.nodes.begin(), end, node) == end) corners.nodes[corners.count++] = node;
  }
  return corners;
}

/// Cut from the least node, so that the diagonal does not depend on how the cell names its corners.
void addTriangles(const Corners& corners, CellIndex cell, std::vector<OutsideTriangle>& triangles) {
  if (corners.count < 3) return;
  std::size_t least = 0;
  for (std::size_t i = 1; i < corners.count; ++i) least = corners.nodes[i] < corners.nodes[least] ? i : least;
  for (std::size_t i = 1; i + 1 < corners.count; ++i) {
    triangles.push_back({{corners.nodes[least], corners.nodes[(least + i) % corners.count],
                          corners.nodes[(least + i + 1) % corners.count]},
                         cell});
  }
}

}  // namespace

Vec3 normalOf(const OutsideTriangle& triangle, const NodeVectors& positions) {
  const Vec3 a = positions.get(triangle.nodes[0]);
  return (positions.get(triangle.nodes[1]) - a).cross(positions.get(triangle.nodes[2]) - a).normalized();
}

Outside::Outside(const Network& network) : network_(&network) {
  struct Sorted {
    std::array<NodeIndex, 4> nodes;
    Side side;
  };
  std::vector<Sorted> sides;
  sides.reserve(kCellSides * network.cellCount());
  for (CellIndex cell = 0; cell < network.cellCount(); ++cell) {
    for (std::uint8_t side = 0; side < kCellSides; ++side) {
      Sorted each{{}, {cell, side, false}};
      for (std::size_t i = 0; i < 4; ++i) each.nodes[i] = network.cells[cell][kSideCorners[side][i]];
      std::ranges::sort(each.nodes);
      sides.push_back(each);
    }
  }
  std::ranges::sort(sides, [](const Sorted& left, const Sorted& right) {
    return left.nodes != right.nodes ? left.nodes < right.nodes : left.side.cell < right.side.cell;
  });
  sides_.reserve(sides.size());
  for (std::size_t s = 0; s < sides.size(); ++s) {
    sides_.push_back(sides[s].side);
    sides_.back().last = s + 1 == sides.size() || sides[s + 1].nodes != sides[s].nodes;
  }
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
  const auto isWhole = [&](CellIndex cell) { return brokenCells_.empty() || brokenCells_[cell] == 0; };
  triangles_.clear();
  loose_.assign(network_->nodeCount(), 1);
  for (CellIndex cell = 0; cell < network_->cellCount(); ++cell) {
    if (!isWhole(cell)) continue;
    for (const NodeIndex node : network_->cells[cell]) loose_[node] = 0;
  }
  std::size_t whole = 0;
  Side outer;
  for (const Side& side : sides_) {
    if (isWhole(side.cell)) {
      ++whole;
      outer = side;
    }
    if (!side.last) continue;
    if (whole == 1) addTriangles(cornersOf(*network_, outer.cell, outer.index), outer.cell, triangles_);
    whole = 0;
  }
  join();
}

void Outside::join() {
  struct Half {
    NodeIndex low, high;
    CellIndex cell;
    std::uint32_t triangle;
  };
  const std::size_t nodes = network_->nodeCount();
  std::vector<Half> halves(3 * triangles_.size());
  std::vector<std::uint32_t> firstHalf(nodes + 1, 0);
  firstTriangle_.assign(nodes + 1, 0);
  const auto forHalves = [&](const auto& each) {
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const OutsideTriangle& triangle = triangles_[t];
      for (std::size_t i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax(triangle.nodes[i], triangle.nodes[(i + 1) % 3]);
        each(Half{low, high, triangle.cell, t}, triangle.nodes[i]);
      }
    }
  };
  forHalves([&](const Half& half, NodeIndex node) {
    ++firstHalf[half.low + 1];
    ++firstTriangle_[node + 1];
  });
  for (std::size_t n = 0; n < nodes; ++n) {
    firstHalf[n + 1] += firstHalf[n];
    firstTriangle_[n + 1] += firstTriangle_[n];
  }
  trianglesOfNode_.resize(halves.size());
  std::vector<std::uint32_t> nextHalf(firstHalf.begin(), firstHalf.end() - 1);
  std::vector<std::uint32_t> next(firstTriangle_.begin(), firstTriangle_.end() - 1);
  forHalves([&](const Half& half, NodeIndex node) {
    halves[nextHalf[half.low]++] = half;
    trianglesOfNode_[next[node]++] = half.triangle;
  });
  // By their lower node already; a node has few.
  for (std::size_t n = 0; n < nodes; ++n) {
    std::sort(halves.begin() + firstHalf[n], halves.begin() + firstHalf[n + 1],
              [](const Half& left, const Half& right) {
                return std::tie(left.high, left.cell, left.triangle) <
                       std::tie(right.high, right.cell, right.triangle);
              });
  }
  edges_.clear();
  const auto pair = [&](const Half& one, const Half& two) {
    edges_.push_back({{one.low, one.high}, {one.triangle, two.triangle}});
  };
  std::vector<Half> left;
  for (std::size_t h = 0; h < halves.size();) {
    std::size_t end = h + 1;
    while (end < halves.size() && halves[end].low == halves[h].low && halves[end].high == halves[h].high)
      ++end;
    // Where cells meet in an edge only, each keeps to its own two sides.
    left.clear();
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
  return bytes(sides_) + bytes(brokenCells_) + bytes(triangles_) + bytes(edges_) + bytes(firstTriangle_) +
         bytes(trianglesOfNode_) + bytes(loose_);
}

}  // namespace sim
