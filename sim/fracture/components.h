#pragma once

#include <span>
#include <vector>

#include "sim/kernel/bond_layout.h"
#include "sim/state/snapshot.h"

namespace sim {

/// Birth record of a fragment: a connected component of the graph of whole bonds (docs/numerics.md,
/// Breaking 7).
struct FragmentBirth {
  FragmentId parent = kNone;  ///< kNone: there from the start
  double born = 0.0;          ///< s
  std::uint32_t nodeCount = 0;

  bool operator==(const FragmentBirth&) const = default;
};

/// Which fragment each node belongs to. After breaks only the parts that came off are visited: from both ends
/// of every broken bond searches grow in turns until they meet, or one of them has run out of nodes. Those
/// that ran out are the new fragments; what could still grow keeps the old id.
class Components {
 public:
  /// Labels the whole network: ids in order of each component's first node.
  Components(const Network& network, const BondLayout& layout);

  /// After the bonds of `events` were taken out of the layout. True when a new fragment was born.
  bool relabel(const BondLayout& layout, std::span<const BreakEvent> events, double time);

  FragmentId of(NodeIndex node) const { return fragmentOfNode_[node]; }
  const std::vector<FragmentId>& fragmentOfNode() const { return fragmentOfNode_; }
  /// Every fragment ever born, by id; one that gave all its nodes away cannot be, since the rest keeps the
  /// id.
  const std::vector<FragmentBirth>& births() const { return births_; }
  std::uint64_t relabelings() const { return relabelings_; }

  void restore(std::vector<FragmentId> fragmentOfNode, std::vector<FragmentBirth> births,
               std::uint64_t relabelings);
  std::size_t memoryBytes() const;

 private:
  class Search;
  struct NodePair {
    NodeIndex a, b;
  };
  /// The broken bonds are of one fragment.
  bool relabelOne(const BondLayout& layout, std::span<const NodePair> broken, double time);

  std::vector<FragmentId> fragmentOfNode_;
  std::vector<FragmentBirth> births_;
  std::vector<std::uint32_t>
      searchOfNode_;  ///< scratch of relabel, made when first needed: kNone between calls
  std::uint64_t relabelings_ = 0;
};

/// All fragments, by id. Held nodes have no mass.
std::vector<Fragment> describeFragments(const Network& network, const Components& components);

/// How the fragments in Snapshot::broken are, by the snapshot's positions and velocities. Held nodes count in
/// nothing but the box. The fragments must be those of a Components, whose ids count from 0 without a gap.
std::vector<MovingFragment> describeMotion(const Network& network, const Snapshot& snapshot);

}  // namespace sim
