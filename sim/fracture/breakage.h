#pragma once

#include <span>
#include <vector>

#include "sim/network/network.h"
#include "sim/state/snapshot.h"

namespace sim {

/// Which bonds and cells are whole, and how breaking spreads (docs/numerics.md, Breaking 3): when a bond
/// breaks, every cell that contains it is broken; when every cell that contains a bond is broken, that bond
/// breaks too. A cell contains every bond between two of its corners. A bond in no cell breaks alone.
class Breakage {
 public:
  explicit Breakage(const Network& network);

  /// A bond found stretched past its threshold.
  struct Overstretched {
    BondIndex bond;
    float strain;
  };

  /// Breaks these bonds and all that goes with them, adding an event each, in order of cause. Bonds already
  /// broken are passed over. strainOf(bond) is asked for those that a cell takes along.
  template <class StrainOf>
  void breakBonds(std::span<const Overstretched> bonds, double time, StrainOf&& strainOf,
                  std::vector<BreakEvent>& events) {
    makeLists();
    for (const Overstretched& over : bonds) {
      if (bondBroken(over.bond)) continue;
      markBond(over.bond, kNone, over.strain, time, events);
      for (const CellIndex cell : cellsWith(over.bond)) {
        if (cellBroken_[cell] != 0) continue;
        cellBroken_[cell] = 1;
        ++brokenCellCount_;
        for (const BondIndex orphan : orphansOf(cell)) markBond(orphan, cell, strainOf(orphan), time, events);
      }
    }
  }

  bool bondBroken(BondIndex bond) const { return !bondBroken_.empty() && bondBroken_[bond] != 0; }
  /// One byte a bond or cell, 1 where it is broken.
  std::vector<std::uint8_t> brokenBonds() const;
  std::vector<std::uint8_t> brokenCells() const;
  std::uint64_t brokenBondCount() const { return brokenBondCount_; }
  std::uint64_t brokenCellCount() const { return brokenCellCount_; }

  /// For a resumed run.
  void restore(std::vector<std::uint8_t> brokenBonds, std::vector<std::uint8_t> brokenCells);

  std::size_t memoryBytes() const;

 private:
  /// Not before something breaks: what never does needs neither marks nor lists of cells.
  void makeLists();
  void markBond(BondIndex bond, CellIndex cause, float strain, double time, std::vector<BreakEvent>& events);
  /// The cells that contain both of its nodes, ascending.
  std::vector<CellIndex> cellsWith(BondIndex bond) const;
  bool hasWholeCell(NodeIndex a, NodeIndex b) const;
  /// Whole bonds of a cell that just broke which no whole cell contains.
  std::vector<BondIndex> orphansOf(CellIndex cell) const;

  const Network* network_;
  std::vector<std::uint8_t> bondBroken_;  ///< empty until something breaks
  std::vector<std::uint8_t> cellBroken_;  ///< likewise
  std::vector<std::uint32_t> firstCell_;  ///< rows of cellsOfNode_
  std::vector<CellIndex> cellsOfNode_;
  std::uint64_t brokenBondCount_ = 0;
  std::uint64_t brokenCellCount_ = 0;
};

}  // namespace sim
