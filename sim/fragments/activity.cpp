#include "sim/fragments/activity.h"

#include <cassert>

#include "sim/base/blocks.h"

namespace sim {
namespace {

constexpr std::size_t slotOf(FragmentState state) {
  return static_cast<std::size_t>(state);
}

}  // namespace

Activity::Activity(const Network& network, const Components& components) {
  const std::size_t blocks = (network.nodeCount() + kBlockNodes - 1) / kBlockNodes;
  awakeLanes_.assign(blocks, 0);
  movedLanes_.assign(blocks, 0);
  stillLanes_.assign(blocks, 0);
  activeBlocks_.reserve(blocks);
  noteBirths(components);
  refresh(components);
}

void Activity::noteBirths(const Components& components) {
  const std::size_t born = components.births().size() - states_.size();
  states_.resize(components.births().size(), FragmentState::deforming);
  counts_[slotOf(FragmentState::deforming)] += born;
}

void Activity::set(FragmentId fragment, FragmentState state) {
  --counts_[slotOf(states_[fragment])];
  ++counts_[slotOf(state)];
  states_[fragment] = state;
}

void Activity::refresh(const Components& components) {
  const std::vector<FragmentId>& fragmentOfNode = components.fragmentOfNode();
  activeBlocks_.clear();
  ++version_;
  for (std::size_t block = 0; block < awakeLanes_.size(); ++block) {
    unsigned awake = 0;
    unsigned moved = 0;
    const std::size_t first = block * kBlockNodes;
    const std::size_t lanes = std::min(kBlockNodes, fragmentOfNode.size() - first);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const FragmentState state = states_[fragmentOfNode[first + lane]];
      if (state == FragmentState::deforming) awake |= 1U << lane;
      if (state != FragmentState::asleep) moved |= 1U << lane;
    }
    awakeLanes_[block] = static_cast<std::uint16_t>(awake);
    movedLanes_[block] = static_cast<std::uint16_t>(moved);
    stillLanes_[block] = static_cast<std::uint16_t>(~awake & ((1U << lanes) - 1U));
    if (awake != 0) activeBlocks_.push_back(static_cast<std::uint32_t>(block));
  }
}

void Activity::listNodes(const Components& components) {
  const std::vector<FragmentId>& fragmentOfNode = components.fragmentOfNode();
  firstNode_.assign(states_.size() + 1, 0);
  for (const FragmentId fragment : fragmentOfNode) ++firstNode_[fragment + 1];
  for (std::size_t f = 0; f < states_.size(); ++f) firstNode_[f + 1] += firstNode_[f];
  nodes_.resize(fragmentOfNode.size());
  std::vector<std::uint32_t> next(firstNode_.begin(), firstNode_.end() - 1);
  for (NodeIndex node = 0; node < fragmentOfNode.size(); ++node) nodes_[next[fragmentOfNode[node]]++] = node;
}

void Activity::restore(std::vector<FragmentState> states, const Components& components) {
  assert(states.size() == components.births().size());
  states_ = std::move(states);
  counts_ = {};
  for (const FragmentState state : states_) ++counts_[slotOf(state)];
  nodes_.clear();
  refresh(components);
}

std::size_t Activity::memoryBytes() const {
  return states_.capacity() * sizeof(FragmentState) +
         (awakeLanes_.capacity() + movedLanes_.capacity() + stillLanes_.capacity()) * sizeof(std::uint16_t) +
         (activeBlocks_.capacity() + firstNode_.capacity() + nodes_.capacity()) * sizeof(std::uint32_t);
}

}  // namespace sim
