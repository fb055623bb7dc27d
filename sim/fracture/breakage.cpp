#include "sim/fracture/breakage.h"

#include <algorithm>

#include "sim/network/wedge.h"

namespace sim {

Breakage::Breakage(const Network& network) : network_(&network) {}

std::vector<std::uint8_t> Breakage::brokenBonds() const {
  return bondBroken_.empty() ? std::vector<std::uint8_t>(network_->bondCount(), 0) : bondBroken_;
}

std::vector<std::uint8_t> Breakage::brokenCells() const {
  return cellBroken_.empty() ? std::vector<std::uint8_t>(network_->cellCount(), 0) : cellBroken_;
}

void Breakage::makeLists() {
  if (!firstCell_.empty()) return;
  const Network& network = *network_;
  bondBroken_.resize(network.bondCount(), 0);
  cellBroken_.resize(network.cellCount(), 0);
  firstCell_.assign(network.nodeCount() + 1, 0);
  for (const CellCorners& corners : network.cells) {
    for (const NodeIndex corner : DistinctCorners(corners)) ++firstCell_[corner + 1];
  }
  for (std::size_t n = 0; n < network.nodeCount(); ++n) firstCell_[n + 1] += firstCell_[n];
  cellsOfNode_.resize(firstCell_.back());
  std::vector<std::uint32_t> next(firstCell_.begin(), firstCell_.end() - 1);
  for (CellIndex cell = 0; cell < network.cellCount(); ++cell) {
    for (const NodeIndex corner : DistinctCorners(network.cells[cell])) cellsOfNode_[next[corner]++] = cell;
  }
}

void Breakage::markBond(BondIndex bond, CellIndex cause, float strain, double time,
                        std::vector<BreakEvent>& events) {
  bondBroken_[bond] = 1;
  ++brokenBondCount_;
  events.push_back({time, bond, network_->bondStart(bond), network_->bondEnds[bond], strain, cause});
}

std::vector<CellIndex> Breakage::cellsWith(BondIndex bond) const {
  const NodeIndex a = network_->bondStart(bond);
  const NodeIndex b = network_->bondEnds[bond];
  std::vector<CellIndex> cells;
  std::set_intersection(cellsOfNode_.begin() + firstCell_[a], cellsOfNode_.begin() + firstCell_[a + 1],
                        cellsOfNode_.begin() + firstCell_[b], cellsOfNode_.begin() + firstCell_[b + 1],
                        std::back_inserter(cells));
  return cells;
}

bool Breakage::hasWholeCell(NodeIndex a, NodeIndex b) const {
  for (std::uint32_t place = firstCell_[a]; place < firstCell_[a + 1]; ++place) {
    const CellIndex cell = cellsOfNode_[place];
    if (cellBroken_[cell] != 0) continue;
    const CellCorners& corners = network_->cells[cell];
    if (std::find(corners.begin(), corners.end(), b) != corners.end()) return true;
  }
  return false;
}

std::vector<BondIndex> Breakage::orphansOf(CellIndex cell) const {
  std::vector<BondIndex> orphans;
  const DistinctCorners corners(network_->cells[cell]);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      const BondIndex bond = network_->findBond(corners[i], corners[j]);
      if (bond == kNone || bondBroken(bond) || hasWholeCell(corners[i], corners[j])) continue;
      orphans.push_back(bond);
    }
  }
  return orphans;
}

void Breakage::restore(std::vector<std::uint8_t> brokenBonds, std::vector<std::uint8_t> brokenCells) {
  bondBroken_ = std::move(brokenBonds);
  cellBroken_ = std::move(brokenCells);
  const auto nonzero = [](const std::vector<std::uint8_t>& flags) {
    return static_cast<std::uint64_t>(
        std::count_if(flags.begin(), flags.end(), [](std::uint8_t flag) { return flag != 0; }));
  };
  brokenBondCount_ = nonzero(bondBroken_);
  brokenCellCount_ = nonzero(cellBroken_);
}

std::size_t Breakage::memoryBytes() const {
  return bondBroken_.capacity() + cellBroken_.capacity() +
         (firstCell_.capacity() + cellsOfNode_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace sim
