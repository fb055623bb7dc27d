#include "modeling/assembly/bond_sum.h"

#include <algorithm>
#include <array>

#include "sim/base/parallel.h"

namespace modeling {
namespace {

/// (cell, corner) pairs at each node, as rows of one array: 8 * cell + corner, ascending.
struct CornersOfNodes {
  std::vector<std::size_t> first;
  std::vector<std::uint64_t> corners;
};

CornersOfNodes cornersOfNodes(const std::vector<GivingCell>& cells, std::size_t nodeCount) {
  CornersOfNodes rows;
  rows.first.assign(nodeCount + 1, 0);
  for (const auto& cell : cells)
    for (const NodeIndex node : cell.corners) ++rows.first[node + 1];
  for (std::size_t i = 0; i < nodeCount; ++i) rows.first[i + 1] += rows.first[i];
  rows.corners.resize(rows.first.back());
  std::vector<std::size_t> next(rows.first.begin(), rows.first.end() - 1);
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (std::size_t corner = 0; corner < 8; ++corner)
      rows.corners[next[cells[c].corners[corner]]++] = 8 * c + corner;
  return rows;
}

/// The seven pairs that each corner is an end of.
const std::array<std::array<std::uint8_t, 7>, 8> kPairsOfCorner = [] {
  std::array<std::array<std::uint8_t, 7>, 8> pairs{};
  std::array<std::size_t, 8> count{};
  for (std::size_t p = 0; p < kPairsPerCell; ++p)
    for (const std::uint8_t corner : {kCornerPairs[p].a, kCornerPairs[p].b})
      pairs[corner][count[corner]++] = static_cast<std::uint8_t>(p);
  return pairs;
}();

/// What one bond has been given so far.
struct Sum {
  NodeIndex end = 0;
  int givers = 0;
  double stiffness = 0.0;
  double damping = 0.0;
  double most = 0.0;        ///< largest single stiffness given
  double unstrained = 0.0;  ///< sum of stiffness * rest length
  double lastLength = 0.0;
  bool loose = false;  ///< a loose bond gave, so that the rest length may not be the distance
  sim::MaterialIndex material = 0;

  /// Springs side by side act as one whose rest length is their mean by stiffness.
  double restLength() const { return loose && givers > 1 ? unstrained / stiffness : lastLength; }
};

/// The bonds of one node to nodes behind it, while they are added up.
class BondRow {
 public:
  Sum& give(NodeIndex end, double stiffness, double damping, double restLength, sim::MaterialIndex material) {
    auto sum = std::find_if(sums_.begin(), sums_.end(), [&](const Sum& entry) { return entry.end == end; });
    if (sum == sums_.end()) {
      sum = sums_.insert(sums_.end(), Sum{});
      sum->end = end;
    }
    ++sum->givers;
    sum->stiffness += stiffness;
    sum->damping += damping;
    sum->unstrained += stiffness * restLength;
    sum->lastLength = restLength;
    if (stiffness > sum->most) {
      sum->most = stiffness;
      sum->material = material;
    }
    return *sum;
  }

  /// Empties the row.
  void moveTo(NodeIndex start, std::vector<sim::BlueprintBond>& bonds) {
    std::sort(sums_.begin(), sums_.end(), [](const Sum& x, const Sum& y) { return x.end < y.end; });
    for (const Sum& sum : sums_)
      bonds.push_back({start, sum.end, sum.stiffness, sum.restLength(), sum.damping, sum.material});
    sums_.clear();
  }

 private:
  std::vector<Sum> sums_;
};

/// Everything that bonds are added up from.
struct Sources {
  const std::vector<Vec3>& positions;
  const std::vector<GivingCell>& cells;
  const CornersOfNodes& corners;
  const std::vector<GivingBond>& looseBonds;
  const std::vector<PartConstants>& constants;
};

void addCellBonds(const Sources& sources, NodeIndex node, BondRow& row) {
  for (std::size_t i = sources.corners.first[node]; i < sources.corners.first[node + 1]; ++i) {
    const GivingCell& cell = sources.cells[sources.corners.corners[i] / 8];
    const auto corner = static_cast<unsigned>(sources.corners.corners[i] % 8);
    const PartConstants& constants = sources.constants[cell.part];
    for (const std::uint8_t pair : kPairsOfCorner[corner]) {
      const CornerPair& ends = kCornerPairs[pair];
      const NodeIndex other = cell.corners[ends.a == corner ? ends.b : ends.a];
      if (other <= node || !(cell.bonds >> pair & 1U)) continue;
      const double stiffness = constants.youngsModulus * cell.shape->stiffness[pair];
      row.give(other, stiffness, constants.dampingTime * stiffness,
               (sources.positions[other] - sources.positions[node]).norm(), constants.material);
    }
  }
}

std::vector<sim::BlueprintBond> bondsOfNodes(const Sources& sources, std::size_t begin, std::size_t end) {
  std::vector<sim::BlueprintBond> bonds;
  BondRow row;
  auto loose =
      std::lower_bound(sources.looseBonds.begin(), sources.looseBonds.end(), begin,
                       [](const GivingBond& giving, std::size_t node) { return giving.bond.a < node; });
  for (std::size_t node = begin; node < end; ++node) {
    addCellBonds(sources, static_cast<NodeIndex>(node), row);
    for (; loose != sources.looseBonds.end() && loose->bond.a == node; ++loose) {
      const sim::BlueprintBond& bond = loose->bond;
      row.give(bond.b, bond.stiffness, bond.damping, bond.restLength, bond.material).loose = true;
    }
    row.moveTo(static_cast<NodeIndex>(node), bonds);
  }
  return bonds;
}

}  // namespace

std::vector<sim::BlueprintBond> addUpBonds(const std::vector<Vec3>& positions,
                                           const std::vector<GivingCell>& cells,
                                           const std::vector<GivingBond>& looseBonds,
                                           const std::vector<PartConstants>& constants) {
  constexpr std::size_t kNodesPerBlock = 4096;
  const CornersOfNodes corners = cornersOfNodes(cells, positions.size());
  const Sources sources{positions, cells, corners, looseBonds, constants};
  std::vector<std::vector<sim::BlueprintBond>> blocks((positions.size() + kNodesPerBlock - 1) /
                                                      kNodesPerBlock);
  sim::parallelFor(blocks.size(), [&](std::size_t block) {
    const std::size_t begin = block * kNodesPerBlock;
    blocks[block] = bondsOfNodes(sources, begin, std::min(begin + kNodesPerBlock, positions.size()));
  });
  std::size_t count = 0;
  for (const auto& block : blocks) count += block.size();
  std::vector<sim::BlueprintBond> bonds;
  bonds.reserve(count);
  for (auto& block : blocks) {
    bonds.insert(bonds.end(), block.begin(), block.end());
    std::vector<sim::BlueprintBond>().swap(block);  // millions of bonds twice would be the peak of memory
  }
  return bonds;
}

}  // namespace modeling
