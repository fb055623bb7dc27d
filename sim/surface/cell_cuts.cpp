#include "sim/surface/cell_cuts.h"

#include <algorithm>
#include <limits>

namespace sim {

CellCuts::CellCuts(const CellComplex& complex, const Broken& broken, LooseNodes looseNodes)
    : complex_(complex), broken_(broken) {
  findLoose();
  if (looseNodes == LooseNodes::givenToNeighbours) findCarriers();
  const Network& network = complex.network();
  for (CellIndex cell = 0; cell < network.cellCount(); ++cell) {
    if (!isBroken(cell)) continue;
    const Pieces pieces = piecesOf(network.cells[cell]);
    if (std::any_of(pieces.begin(), pieces.end(), [&](std::uint8_t piece) { return piece != pieces[0]; }))
      pieces_.emplace(cell, pieces);
  }
}

void CellCuts::findLoose() {
  const Network& network = complex_.network();
  loose_.assign(network.nodeCount(), 1);
  for (CellIndex cell = 0; cell < network.cellCount(); ++cell) {
    if (isBroken(cell)) continue;
    for (const NodeIndex node : network.cells[cell]) loose_[node] = 0;
  }
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    for (BondIndex bond = network.firstBond[node]; bond < network.firstBond[node + 1]; ++bond) {
      if (broken_.hasLostBond(bond)) continue;
      loose_[node] = 0;
      loose_[network.bondEnds[bond]] = 0;
    }
  }
}

void CellCuts::findCarriers() {
  const Network& network = complex_.network();
  carriers_.resize(network.nodeCount());
  std::vector<NodeIndex> waiting;
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    carriers_[node] = loose_[node] == 0 ? node : kNone;
    if (loose_[node] != 0) waiting.push_back(node);
  }
  std::vector<std::pair<NodeIndex, NodeIndex>> found;
  while (!waiting.empty()) {
    found.clear();
    for (const NodeIndex node : waiting) {
      NodeIndex nearest = kNone;
      double distance = std::numeric_limits<double>::infinity();
      for (const CellIndex cell : complex_.cellsOf(node)) {
        for (const NodeIndex other : network.cells[cell]) {
          if (carriers_[other] == kNone) continue;
          const double apart = (network.positions[other] - network.positions[node]).squaredNorm();
          if (apart >= distance) continue;
          distance = apart;
          nearest = carriers_[other];
        }
      }
      if (nearest != kNone) found.emplace_back(node, nearest);
    }
    // Where a whole body went to pieces there is no neighbour to give anything to.
    if (found.empty()) break;
    for (const auto& [node, carrier] : found) carriers_[node] = carrier;
    std::erase_if(waiting, [&](NodeIndex node) { return carriers_[node] != kNone; });
  }
  for (const NodeIndex node : waiting) carriers_[node] = node;
  carries_.assign(network.nodeCount(), 0);
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    if (carriers_[node] != node) carries_[carriers_[node]] = 1;
  }
}

bool CellCuts::areJoined(NodeIndex a, NodeIndex b) const {
  if (a == b) return true;
  const NodeIndex carrierA = carrierOf(a);
  const NodeIndex carrierB = carrierOf(b);
  if (carrierA != a || carrierB != b) return carrierA == carrierB || areNear(carrierA, carrierB);
  const BondIndex bond = complex_.network().findBond(a, b);
  return bond != kNone && !broken_.hasLostBond(bond);
}

std::vector<NodeIndex> CellCuts::heldAround(NodeIndex node) const {
  std::vector<NodeIndex> nodes;
  for (const CellIndex cell : complex_.cellsOf(node)) {
    if (isBroken(cell)) continue;
    const CellCorners& corners = complex_.network().cells[cell];
    nodes.insert(nodes.end(), corners.begin(), corners.end());
  }
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

bool CellCuts::areNear(NodeIndex a, NodeIndex b) const {
  const std::vector<NodeIndex> aroundA = heldAround(a);
  const std::vector<NodeIndex> aroundB = heldAround(b);
  return std::any_of(aroundA.begin(), aroundA.end(), [&](NodeIndex node) {
    return std::binary_search(aroundB.begin(), aroundB.end(), node);
  });
}

CellCuts::Pieces CellCuts::piecesOf(const CellCorners& corners) const {
  Pieces pieces{};
  for (std::uint8_t corner = 0; corner < kCellCorners; ++corner) pieces[corner] = corner;
  for (std::uint32_t i = 0; i < kCellCorners; ++i) {
    for (std::uint32_t j = i + 1; j < kCellCorners; ++j) {
      if (pieces[i] == pieces[j] || !areJoined(corners[i], corners[j])) continue;
      const std::uint8_t kept = std::min(pieces[i], pieces[j]);
      const std::uint8_t dropped = std::max(pieces[i], pieces[j]);
      std::replace(pieces.begin(), pieces.end(), dropped, kept);
    }
  }
  return pieces;
}

}  // namespace sim
