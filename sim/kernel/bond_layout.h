#pragma once

#include <span>

#include "sim/base/aligned.h"
#include "sim/kernel/bond_kernel.h"
#include "sim/network/network.h"

namespace sim {

/// The network's bonds as the kernel reads them: for each block of sixteen nodes the slots of its directions,
/// ordered by offset, with the irregular rest in gathered slots. Always built from the whole network, then
/// bonds are removed one by one, so that the order of sums, and with it every bit of the result, depends on
/// what broke and not on when it was built.
class BondLayout {
 public:
  explicit BondLayout(const Network& network);

  std::size_t blockCount() const { return firstSlot_.size(); }
  /// Bonds of the whole network that the kernel need not test, since they cannot break, or whose dampers have
  /// no strength.
  std::uint64_t untestedBonds() const { return untestedEnds_ / 2; }
  std::uint64_t undampedBonds() const { return undampedEnds_ / 2; }

  /// Takes a bond out at both ends. The bond must still be in.
  void remove(const Network& network, BondIndex bond);

  /// Rest length of a bond as it is now (it flows in plastic materials).
  double restLength(const Network& network, BondIndex bond) const;

  /// Calls visit(neighbour) for every node joined to `node` by a bond still in, in the order of sums.
  template <class Visit>
  void forEachNeighbour(NodeIndex node, Visit&& visit) const {
    const std::size_t block = node / kBlockNodes;
    const unsigned lane = node % kBlockNodes;
    const BondSlot* const first = slots_.data() + firstSlot_[block];
    for (const BondSlot* slot = first; slot != first + slotCount_[block]; ++slot) {
      if (((slot->live >> lane) & 1U) == 0) continue;
      visit(slot->gathered ? gathers_[static_cast<std::size_t>(slot->where) + lane]
                           : static_cast<NodeIndex>(static_cast<std::int64_t>(node) + slot->where));
    }
  }

  /// Points a kernel step at the slots.
  void describe(KernelStep& step) const;

  /// All plastic rest lengths, for checkpoints.
  std::vector<double> plasticRestLengths() const;
  void setPlasticRestLengths(std::span<const double> lengths);
  bool hasPlastic() const { return hasPlastic_; }

  std::size_t memoryBytes() const;

 private:
  struct Place {
    BondSlot* slot = nullptr;
    unsigned lane = 0;
  };
  class Builder;

  /// Where the bond of `node` to `neighbour` is gathered.
  Place find(NodeIndex node, NodeIndex neighbour) const;
  void clear(NodeIndex node, NodeIndex neighbour);

  // A block's slots stand together; those whose lanes are all dead move behind the block's slotCount.
  mutable AlignedVector<BondSlot> slots_;
  std::vector<std::uint32_t> firstSlot_;
  std::vector<std::uint16_t> slotCount_;
  std::vector<SlotConstants> constants_;  ///< of uniform slots, one a class
  mutable AlignedVector<SlotLanes> lanes_;
  std::vector<std::uint32_t> gathers_;
  bool hasPlastic_ = false;
  std::uint64_t untestedEnds_ = 0;  ///< bonds seen from either end
  std::uint64_t undampedEnds_ = 0;
};

}  // namespace sim
