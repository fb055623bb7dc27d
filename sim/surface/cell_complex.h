#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/network/cell_shape.h"
#include "sim/network/network.h"
#include "sim/network/wedge.h"

namespace sim {

/// How the cells of a network hang together before anything breaks: made once, it serves the surface of every
/// moment. A face is named 6 cell + side; a wedge's collapsed sides are none. Building is linear in the
/// number of cells.
class CellComplex {
 public:
  /// Cells that are joined by common nodes.
  struct Body {
    std::vector<CellIndex> cells;
    std::vector<NodeIndex> nodes;
    std::vector<std::uint32_t> outsideFaces;  ///< places in outsideFaces(), in order of their cells
  };
  /// A side of an outside face, found by its edge.
  struct OutsideEdge {
    NodeIndex low;
    NodeIndex high;
    std::uint32_t face;  ///< place in outsideFaces()
    std::uint8_t side;   ///< from the face's corner `side` to the next; a triangle has no side 2
  };

  /// Keeps a reference to the network.
  explicit CellComplex(const Network& network);

  const Network& network() const { return network_; }
  SideNodes nodesOf(std::uint32_t face) const {
    return sideNodes(network_.cells[face / kCellSides], face % kCellSides);
  }
  /// The next face of the same four nodes, in a ring; the face itself where it is outside.
  std::uint32_t twinOf(std::uint32_t face) const { return twins_[face]; }
  /// Faces that no other cell shares: the outside of the whole bodies.
  const std::vector<std::uint32_t>& outsideFaces() const { return outsideFaces_; }
  /// kNone for a face between cells and a collapsed side, otherwise its place in outsideFaces().
  std::uint32_t outsidePlace(std::uint32_t face) const;
  std::span<const OutsideEdge> outsideEdges(NodeIndex a, NodeIndex b) const;
  std::span<const CellIndex> cellsOf(NodeIndex node) const {
    return {cellsOfNode_.data() + firstCell_[node], cellsOfNode_.data() + firstCell_[node + 1]};
  }
  const std::vector<Body>& bodies() const { return bodies_; }
  /// Nodes of no cell, such as a raw network's.
  const std::vector<NodeIndex>& bareNodes() const { return bareNodes_; }

  /// What a cell is made of. One of two materials came about by gluing: the glue bonds keep the material of
  /// the part whose cell it was.
  MaterialIndex materialOf(CellIndex cell) const;
  /// Whose cell it was: one with nodes of two parts is of one of them, and stands among its cells.
  PartIndex partOf(CellIndex cell) const { return parts_[cell]; }
  /// Whether a face is of a cell that was glued with all of the face's nodes: it lies on the other part, or
  /// in it, and is not to be seen.
  bool isCovered(std::uint32_t face) const;

 private:
  void findTwins();
  void listCellsOfNodes();
  void listOutside();
  void findBodies();
  void findParts();

  const Network& network_;
  std::vector<std::uint32_t> twins_;
  std::vector<std::uint32_t> outsideFaces_;  ///< ascending
  std::vector<OutsideEdge> outsideEdges_;    ///< sorted by low, then high
  std::vector<std::uint32_t> firstCell_;
  std::vector<CellIndex> cellsOfNode_;
  std::vector<Body> bodies_;
  std::vector<NodeIndex> bareNodes_;
  std::vector<PartIndex> parts_;  ///< one a cell
};

}  // namespace sim
