#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/fracture/components.h"
#include "sim/network/network.h"
#include "sim/state/snapshot.h"

namespace sim {

/// How each fragment moves, and which lanes of the lattice the kernel has to work on for it. All nodes
/// of a fragment move alike, and bonds join nodes of one fragment, so a bond is evaluated from both ends or
/// from none.
class Activity {
 public:
  Activity(const Network& network, const Components& components);

  FragmentState stateOf(FragmentId fragment) const { return states_[fragment]; }
  bool deforms(FragmentId fragment) const { return states_[fragment] == FragmentState::deforming; }
  bool nodeDeforms(NodeIndex node) const {
    return ((static_cast<unsigned>(awakeLanes_[node / kBlockNodes]) >> (node % kBlockNodes)) & 1U) != 0;
  }
  bool any(FragmentState state) const { return counts_[static_cast<std::size_t>(state)] > 0; }
  std::size_t fragmentCount() const { return states_.size(); }

  /// Fragments were born: they deform, as those they came from must have.
  void noteBirths(const Components& components);
  /// Takes effect on lanes and blocks at the next refresh().
  void set(FragmentId fragment, FragmentState state);
  void refresh(const Components& components);

  /// Another number after every refresh().
  std::uint64_t version() const { return version_; }
  /// Bit a lane, one number a block: the node deforms.
  std::span<const std::uint16_t> awakeLanes() const { return awakeLanes_; }
  /// The same for nodes that are moved by forces: those that do not sleep.
  std::span<const std::uint16_t> movedLanes() const { return movedLanes_; }
  /// The same for nodes that do not deform.
  std::span<const std::uint16_t> stillLanes() const { return stillLanes_; }
  /// Blocks with a node that deforms, ascending.
  std::span<const std::uint32_t> activeBlocks() const { return activeBlocks_; }

  /// Nodes of a fragment, ascending. Valid until fragments are born; listNodes() makes it so again.
  std::span<const NodeIndex> nodesOf(FragmentId fragment) const {
    return std::span(nodes_).subspan(firstNode_[fragment], firstNode_[fragment + 1] - firstNode_[fragment]);
  }

  void listNodes(const Components& components);
  void restore(std::vector<FragmentState> states, const Components& components);
  const std::vector<FragmentState>& states() const { return states_; }
  std::size_t memoryBytes() const;

 private:
  std::vector<FragmentState> states_;
  std::array<std::size_t, kFragmentStates> counts_{};  ///< fragments in each state
  std::vector<std::uint16_t> awakeLanes_;
  std::vector<std::uint16_t> movedLanes_;
  std::vector<std::uint16_t> stillLanes_;
  std::vector<std::uint32_t> activeBlocks_;
  std::vector<std::uint32_t> firstNode_;
  std::vector<NodeIndex> nodes_;
  std::uint64_t version_ = 0;
};

}  // namespace sim
