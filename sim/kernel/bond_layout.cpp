#include "sim/kernel/bond_layout.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <tuple>
#include <unordered_map>

#include <xxhash.h>

namespace sim {
namespace {

/// Directions shared by fewer lanes of a block than this are gathered: a contiguous slot costs about as much
/// as a gathered one of the same number of lanes, but gathered slots pack several directions together.
constexpr std::size_t kFewestContiguous = 4;
/// A slot with breakRatio 1 is suspect when stretched at all: thresholds this small are tested exactly.
float breakRatioOf(float threshold) {
  const double ratio = 1.0 / (1.0 + (1.0 - 1e-6) * static_cast<double>(threshold));
  return std::min(1.0F, std::nextafter(static_cast<float>(ratio), 2.0F));
}

/// One end of one bond.
struct HalfBond {
  std::int32_t offset;
  std::uint8_t lane;
  std::uint8_t material;
  BondIndex bond;
};

/// Bonds seen from their second node: for each node, the bonds in whose row it is not.
struct LowerRows {
  std::vector<std::uint32_t> first;
  std::vector<BondIndex> bonds;
  std::vector<NodeIndex> starts;

  explicit LowerRows(const Network& network)
      : first(network.nodeCount() + 1, 0), bonds(network.bondCount()), starts(network.bondCount()) {
    for (const NodeIndex end : network.bondEnds) ++first[end + 1];
    for (std::size_t n = 0; n < network.nodeCount(); ++n) first[n + 1] += first[n];
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (NodeIndex a = 0; a < network.nodeCount(); ++a) {
      for (BondIndex b = network.firstBond[a]; b < network.firstBond[a + 1]; ++b) {
        const std::uint32_t place = next[network.bondEnds[b]]++;
        bonds[place] = b;
        starts[place] = a;
      }
    }
  }
};

}  // namespace

class BondLayout::Builder {
 public:
  Builder(const Network& network, BondLayout& layout) : network_(network), layout_(layout), lower_(network) {}

  void addBlock(std::size_t block) {
    collect(block);
    layout_.firstSlot_.push_back(static_cast<std::uint32_t>(layout_.slots_.size()));
    rest_.clear();
    for (std::size_t first = 0; first < halves_.size();) {
      std::size_t last = first + 1;
      while (last < halves_.size() && halves_[last].offset == halves_[first].offset &&
             halves_[last].material == halves_[first].material) {
        ++last;
      }
      const std::span run(halves_.data() + first, last - first);
      if (run.size() >= kFewestContiguous) {
        addSlot(run, block, false);
      } else {
        rest_.insert(rest_.end(), run.begin(), run.end());
      }
      first = last;
    }
    addGathered(block);
    layout_.slotCount_.push_back(
        static_cast<std::uint16_t>(layout_.slots_.size() - layout_.firstSlot_.back()));
  }

 private:
  void collect(std::size_t block) {
    halves_.clear();
    const std::size_t begin = block * kBlockNodes;
    const std::size_t end = std::min(begin + kBlockNodes, network_.nodeCount());
    for (std::size_t node = begin; node < end; ++node) {
      for (std::uint32_t p = lower_.first[node]; p < lower_.first[node + 1]; ++p)
        add(node, lower_.starts[p], lower_.bonds[p], begin);
      for (BondIndex b = network_.firstBond[node]; b < network_.firstBond[node + 1]; ++b)
        add(node, network_.bondEnds[b], b, begin);
    }
    std::sort(halves_.begin(), halves_.end(), [](const HalfBond& left, const HalfBond& right) {
      return std::tuple(left.offset, left.material, left.lane) <
             std::tuple(right.offset, right.material, right.lane);
    });
  }

  void add(std::size_t node, NodeIndex neighbour, BondIndex bond, std::size_t begin) {
    halves_.push_back(
        {static_cast<std::int32_t>(static_cast<std::int64_t>(neighbour) - static_cast<std::int64_t>(node)),
         static_cast<std::uint8_t>(node - begin), static_cast<std::uint8_t>(network_.bond(bond).material),
         bond});
  }

  /// Packs what is left, material by material: the n-th leftover of each lane shares a slot.
  void addGathered(std::size_t block) {
    std::stable_sort(rest_.begin(), rest_.end(), [](const HalfBond& left, const HalfBond& right) {
      return std::tuple(left.material, left.lane) < std::tuple(right.material, right.lane);
    });
    std::vector<HalfBond> layer;
    while (!rest_.empty()) {
      layer.clear();
      std::vector<HalfBond> later;
      for (const HalfBond& half : rest_) {
        const bool fits =
            layer.empty() || (layer.back().material == half.material && layer.back().lane != half.lane);
        (fits ? layer : later).push_back(half);
      }
      addSlot(layer, block, true);
      rest_.swap(later);
    }
  }

  void addSlot(std::span<const HalfBond> run, std::size_t block, bool gathered) {
    const Material& material = network_.materials[run.front().material];
    BondSlot slot{};
    slot.where = run.front().offset;
    slot.material = run.front().material;
    slot.gathered = gathered;
    slot.plastic = std::isfinite(material.yieldStrain) && material.flowRate > 0.0;
    slot.varied = slot.plastic || std::any_of(run.begin(), run.end(), [&](const HalfBond& half) {
                    return network_.bondClasses[half.bond] != network_.bondClasses[run.front().bond];
                  });
    float threshold = std::numeric_limits<float>::infinity();
    for (const HalfBond& half : run) {
      slot.live = static_cast<std::uint16_t>(slot.live | (1U << half.lane));
      slot.damped = slot.damped || network_.bond(half.bond).damping > 0.0;
      threshold = std::min(threshold, network_.thresholds[half.bond]);
    }
    slot.breakRatio = breakRatioOf(threshold);
    const bool breakable = std::isfinite(threshold);
    slot.tested = breakable && (gathered || slot.where > 0);
    if (!breakable) layout_.untestedEnds_ += run.size();
    if (!slot.damped) layout_.undampedEnds_ += run.size();
    slot.constants = slot.varied ? addLanes(run, slot.plastic) : constantsOf(run.front());
    if (gathered) slot.where = addGather(run, block);
    layout_.hasPlastic_ = layout_.hasPlastic_ || slot.plastic;
    layout_.slots_.push_back(slot);
  }

  std::uint32_t constantsOf(const HalfBond& half) {
    const auto fresh = static_cast<std::uint32_t>(layout_.constants_.size());
    const auto [entry, isNew] = placeOfClass_.try_emplace(network_.bondClasses[half.bond], fresh);
    if (!isNew) return entry->second;
    const BondClass& common = network_.bond(half.bond);
    layout_.constants_.push_back({common.stiffness, common.restLength, common.damping});
    return fresh;
  }

  /// Where rows of a lattice end within blocks, the same mixture of constants comes again and again, and one
  /// record serves them all. What flows must have its own.
  std::uint32_t addLanes(std::span<const HalfBond> run, bool plastic) {
    SlotLanes lanes{};
    std::fill(std::begin(lanes.restLength), std::end(lanes.restLength), 1.0);
    for (const HalfBond& half : run) {
      const BondClass& bond = network_.bond(half.bond);
      lanes.stiffness[half.lane] = bond.stiffness;
      lanes.restLength[half.lane] = bond.restLength;
      lanes.damping[half.lane] = bond.damping;
    }
    const auto fresh = static_cast<std::uint32_t>(layout_.lanes_.size());
    if (!plastic) {
      const auto [entry, isNew] = placeOfLanes_.try_emplace(XXH3_64bits(&lanes, sizeof lanes), fresh);
      // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): bits are meant.
      if (!isNew && std::memcmp(&layout_.lanes_[entry->second], &lanes, sizeof lanes) == 0)
        return entry->second;
    }
    layout_.lanes_.push_back(lanes);
    return fresh;
  }

  /// Dead lanes name their own node: in range, and their force is masked away.
  std::int32_t addGather(std::span<const HalfBond> run, std::size_t block) {
    const std::size_t place = layout_.gathers_.size();
    assert(place <= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()));
    const auto begin = static_cast<std::uint32_t>(block * kBlockNodes);
    for (std::uint32_t lane = 0; lane < kBlockNodes; ++lane) layout_.gathers_.push_back(begin + lane);
    for (const HalfBond& half : run) {
      layout_.gathers_[place + half.lane] =
          static_cast<std::uint32_t>(static_cast<std::int64_t>(begin + half.lane) + half.offset);
    }
    return static_cast<std::int32_t>(place);
  }

  const Network& network_;
  BondLayout& layout_;
  LowerRows lower_;
  std::unordered_map<std::uint32_t, std::uint32_t> placeOfClass_;  ///< in constants_
  std::unordered_map<XXH64_hash_t, std::uint32_t> placeOfLanes_;
  std::vector<HalfBond> halves_;
  std::vector<HalfBond> rest_;
};

BondLayout::BondLayout(const Network& network) {
  assert(network.materials.size() <= 256);
  const std::size_t blocks = (network.nodeCount() + kBlockNodes - 1) / kBlockNodes;
  Builder builder(network, *this);
  for (std::size_t block = 0; block < blocks; ++block) builder.addBlock(block);
  slots_.shrink_to_fit();
  lanes_.shrink_to_fit();
  gathers_.shrink_to_fit();
}

BondLayout::Place BondLayout::find(NodeIndex node, NodeIndex neighbour) const {
  const std::size_t block = node / kBlockNodes;
  const unsigned lane = node % kBlockNodes;
  BondSlot* const first = slots_.data() + firstSlot_[block];
  for (BondSlot* slot = first; slot != first + slotCount_[block]; ++slot) {
    if (((slot->live >> lane) & 1U) == 0) continue;
    const bool here = slot->gathered ? gathers_[static_cast<std::size_t>(slot->where) + lane] == neighbour
                                     : static_cast<std::int64_t>(node) + slot->where ==
                                           static_cast<std::int64_t>(neighbour);
    if (here) return {slot, lane};
  }
  return {};
}

void BondLayout::clear(NodeIndex node, NodeIndex neighbour) {
  const Place place = find(node, neighbour);
  assert(place.slot != nullptr);
  place.slot->live = static_cast<std::uint16_t>(place.slot->live & ~(1U << place.lane));
  if (place.slot->live != 0) return;
  const std::size_t block = node / kBlockNodes;
  BondSlot* const end = slots_.data() + firstSlot_[block] + slotCount_[block];
  std::rotate(place.slot, place.slot + 1, end);
  --slotCount_[block];
}

void BondLayout::remove(const Network& network, BondIndex bond) {
  const NodeIndex a = network.bondStart(bond);
  const NodeIndex b = network.bondEnds[bond];
  clear(a, b);
  clear(b, a);
}

double BondLayout::restLength(const Network& network, BondIndex bond) const {
  if (!hasPlastic_) return network.bond(bond).restLength;
  const Place place = find(network.bondStart(bond), network.bondEnds[bond]);
  if (place.slot == nullptr || !place.slot->varied) return network.bond(bond).restLength;
  return lanes_[place.slot->constants].restLength[place.lane];
}

void BondLayout::describe(KernelStep& step) const {
  step.slots = slots_.data();
  step.firstSlot = firstSlot_.data();
  step.slotCount = slotCount_.data();
  step.constants = constants_.data();
  step.lanes = lanes_.data();
  step.gathers = gathers_.data();
}

std::vector<double> BondLayout::plasticRestLengths() const {
  std::vector<double> lengths;
  if (!hasPlastic_) return lengths;
  lengths.reserve(lanes_.size() * kBlockNodes);
  for (const SlotLanes& lanes : lanes_)
    lengths.insert(lengths.end(), std::begin(lanes.restLength), std::end(lanes.restLength));
  return lengths;
}

void BondLayout::setPlasticRestLengths(std::span<const double> lengths) {
  if (!hasPlastic_) return;
  assert(lengths.size() == lanes_.size() * kBlockNodes);
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    std::copy_n(lengths.begin() + static_cast<std::ptrdiff_t>(i * kBlockNodes), kBlockNodes,
                std::begin(lanes_[i].restLength));
  }
}

std::size_t BondLayout::memoryBytes() const {
  return slots_.capacity() * sizeof(BondSlot) +
         (firstSlot_.capacity() + gathers_.capacity()) * sizeof(std::uint32_t) +
         slotCount_.capacity() * sizeof(std::uint16_t) + lanes_.capacity() * sizeof(SlotLanes) +
         constants_.capacity() * sizeof(SlotConstants);
}

}  // namespace sim
