#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/base/bytes.h"
#include "sim/fracture/breakage.h"
#include "sim/network/network.h"
#include "sim/state/motion.h"

namespace sim {

/// A triangle of the outside, counter-clockwise seen from outside.
struct OutsideTriangle {
  std::array<NodeIndex, 3> nodes;
  CellIndex cell = 0;
};

/// Unit, outwards, of the triangle as it is now.
Vec3 normalOf(const OutsideTriangle& triangle, const NodeVectors& positions);

/// An edge of two triangles of the outside.
struct OutsideEdge {
  std::array<NodeIndex, 2> nodes;
  std::array<std::uint32_t, 2> triangles;
};

/// The outside of what is made of cells: the sides of whole cells that no other whole cell shares, each cut
/// into two triangles. Breaking changes it, motion does not.
class Outside {
 public:
  explicit Outside(const Network& network);

  /// Makes it that of the cells which are still whole.
  void follow(const Breakage& breakage);

  const std::vector<OutsideTriangle>& triangles() const { return triangles_; }
  const std::vector<OutsideEdge>& edges() const { return edges_; }
  std::span<const std::uint32_t> trianglesOf(NodeIndex node) const {
    return std::span(trianglesOfNode_)
        .subspan(firstTriangle_[node], firstTriangle_[node + 1] - firstTriangle_[node]);
  }
  std::size_t nodeCount() const { return loose_.size(); }
  /// No whole cell holds it.
  bool isLoose(NodeIndex node) const { return loose_[node] != 0; }
  bool isOutside(NodeIndex node) const { return firstTriangle_[node] != firstTriangle_[node + 1]; }
  /// Becomes the other's, of an equal network.
  void takeOver(const Outside& other);
  void save(ByteWriter& writer) const;
  /// False where the bytes cannot have come from save() of such a network.
  bool load(ByteReader& reader);
  std::size_t memoryBytes() const;

 private:
  /// A side of a cell.
  struct Side {
    CellIndex cell = 0;
    std::uint8_t index = 0;
    bool last = false;  ///< of those that have the same corners
  };
  void find();
  void join();

  const Network* network_;
  std::vector<Side> sides_;  ///< of all cells, broken ones too, by their corners
  std::vector<OutsideTriangle> triangles_;
  std::vector<OutsideEdge> edges_;
  std::vector<std::uint32_t> firstTriangle_, trianglesOfNode_;
  std::vector<std::uint8_t> loose_;
  std::vector<std::uint8_t> brokenCells_;  ///< one byte a cell; empty: none is
  std::uint64_t brokenCount_ = 0;
};

}  // namespace sim
