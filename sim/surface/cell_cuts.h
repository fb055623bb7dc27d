#pragma once

#include <array>
#include <unordered_map>
#include <vector>

#include "sim/state/snapshot.h"
#include "sim/surface/cell_complex.h"

namespace sim {

/// How nodes are shown that nothing holds any more.
enum class LooseNodes : std::uint8_t {
  shards,            ///< convex splinters that fill the volume which their cells had
  tetrahedra,        ///< as in the paper (section "Rendering")
  spheres,           ///< as large as the tetrahedra
  givenToNeighbours  ///< not at all: their material stays with the fragments beside them, as if it had held
};

/// Into which pieces breaking cuts the cells of one moment. Each corner of a cell owns the eighth of it that
/// is nearest; eighths hang together where a whole bond, or a chain of them, joins their corners. A whole
/// cell is one piece, and so is a broken one all of whose corners still hang together through its neighbours.
class CellCuts {
 public:
  /// Keeps references to both.
  CellCuts(const CellComplex& complex, const Broken& broken, LooseNodes looseNodes);

  /// Without a whole cell or bond.
  bool isLoose(NodeIndex node) const { return loose_[node] != 0; }
  bool isBroken(CellIndex cell) const { return broken_.hasLostCell(cell); }
  /// The node whose motion carries the eighths about a node: itself, except where it is loose and given to
  /// its neighbours.
  NodeIndex carrierOf(NodeIndex node) const { return carriers_.empty() ? node : carriers_[node]; }
  /// Whether material of loose nodes was given to it.
  bool carriesOthers(NodeIndex node) const { return !carries_.empty() && carries_[node] != 0; }
  bool isCut(CellIndex cell) const { return pieces_.contains(cell); }
  /// Equal for corners of a cell that are in one piece.
  std::uint8_t pieceOf(CellIndex cell, std::uint32_t corner) const {
    const auto found = pieces_.find(cell);
    return found == pieces_.end() ? std::uint8_t{0} : found->second[corner];
  }

 private:
  using Pieces = std::array<std::uint8_t, kCellCorners>;

  void findLoose();
  /// Each loose node goes to the nearest node that holds and is in a cell with it, or where there is none, to
  /// where the loose nodes beside it went.
  void findCarriers();
  Pieces piecesOf(const CellCorners& corners) const;
  /// The nodes of the whole cells about a node, sorted.
  std::vector<NodeIndex> heldAround(NodeIndex node) const;
  /// Whether whole cells about the two have a node in common. That they are of one fragment is not enough for
  /// what they carry to hang together: a crack may gape between them.
  bool areNear(NodeIndex a, NodeIndex b) const;
  bool areJoined(NodeIndex a, NodeIndex b) const;

  const CellComplex& complex_;
  const Broken& broken_;
  std::vector<std::uint8_t> loose_;
  std::vector<NodeIndex> carriers_;
  std::vector<std::uint8_t> carries_;
  std::unordered_map<CellIndex, Pieces> pieces_;  ///< of the cells that are cut
};

}  // namespace sim
