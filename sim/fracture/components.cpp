#include "sim/fracture/components.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <tuple>

namespace sim {

Components::Components(const Network& network, const BondLayout& layout)
    : fragmentOfNode_(network.nodeCount(), kNone) {
  std::vector<NodeIndex> open;
  for (NodeIndex start = 0; start < network.nodeCount(); ++start) {
    if (fragmentOfNode_[start] != kNone) continue;
    const auto id = static_cast<FragmentId>(births_.size());
    births_.push_back({kNone, 0.0, 0});
    fragmentOfNode_[start] = id;
    open.assign(1, start);
    while (!open.empty()) {
      const NodeIndex node = open.back();
      open.pop_back();
      ++births_[id].nodeCount;
      layout.forEachNeighbour(node, [&](NodeIndex neighbour) {
        if (fragmentOfNode_[neighbour] != kNone) return;
        fragmentOfNode_[neighbour] = id;
        open.push_back(neighbour);
      });
    }
  }
}

/// Searches that grow in turns inside one old fragment, from the ends of its broken bonds. Those that meet
/// are one group; a group that has run out of nodes is a whole component.
///
/// The fragment held together before, so all that is asked is whether the ends of each bond still do. Groups
/// answer for each other, and are of one concern, if a broken bond joined them, or if searches of theirs met.
/// A concern is settled when it has one group at most that still grows. When all are, what still grows is one
/// component: on the old way from one growing group to another lie broken bonds and whole components only,
/// and these make all of them one concern. So cracks that are far apart need not find each other.
class Components::Search {
 public:
  Search(const BondLayout& layout, std::vector<std::uint32_t>& searchOfNode, std::span<const NodePair> broken)
      : layout_(layout), searchOfNode_(searchOfNode) {
    for (const NodePair& bond : broken) {
      const std::uint32_t first = seedAt(bond.a);
      joinConcerns(first, seedAt(bond.b));
    }
    while (unsettled_ > 0) {
      for (std::uint32_t s = 0; s < group_.size() && unsettled_ > 0; ++s) {
        if (group_[s] == s && isOpen(s) && growing_[root(concern_, s)] > 1) expand(s);
      }
    }
  }

  /// The groups that are whole components and do not keep the old id, each with its nodes, by first seed.
  std::vector<std::vector<NodeIndex>> cutOff() {
    std::uint32_t keeper = kNone;
    for (std::uint32_t s = 0; s < group_.size(); ++s) {
      if (group_[s] != s) continue;
      if (isOpen(s)) {
        keeper = s;
        break;
      }
      if (keeper == kNone || visited_[s].size() > visited_[keeper].size()) keeper = s;
    }
    std::vector<std::vector<NodeIndex>> pieces;
    for (std::uint32_t s = 0; s < group_.size(); ++s) {
      for (const NodeIndex node : visited_[s]) searchOfNode_[node] = kNone;
      if (group_[s] == s && s != keeper && !isOpen(s)) pieces.push_back(std::move(visited_[s]));
    }
    return pieces;
  }

 private:
  static std::uint32_t root(std::vector<std::uint32_t>& forest, std::uint32_t at) {
    while (forest[at] != at) at = forest[at] = forest[forest[at]];
    return at;
  }

  std::uint32_t seedAt(NodeIndex node) {
    if (searchOfNode_[node] != kNone) return searchOfNode_[node];
    const auto seed = static_cast<std::uint32_t>(group_.size());
    searchOfNode_[node] = seed;
    group_.push_back(seed);
    concern_.push_back(seed);
    growing_.push_back(1);
    visited_.emplace_back(1, node);
    next_.push_back(0);
    return seed;
  }

  /// Not yet out of nodes.
  bool isOpen(std::uint32_t group) const { return next_[group] < visited_[group].size(); }

  void count(std::uint32_t concern, std::uint32_t growing) {
    if (growing_[concern] > 1) --unsettled_;
    growing_[concern] = growing;
    if (growing > 1) ++unsettled_;
  }

  void joinConcerns(std::uint32_t first, std::uint32_t second) {
    const std::uint32_t one = root(concern_, first);
    const std::uint32_t other = root(concern_, second);
    if (one == other) return;
    const std::uint32_t both = growing_[one] + growing_[other];
    count(other, 0);
    concern_[other] = one;
    count(one, both);
  }

  /// Visits the neighbours of one node of group `s`.
  void expand(std::uint32_t s) {
    const NodeIndex node = visited_[s][next_[s]++];
    layout_.forEachNeighbour(node, [&](NodeIndex neighbour) {
      const std::uint32_t seen = searchOfNode_[neighbour];
      const std::uint32_t own = root(group_, s);
      if (seen == kNone) {
        searchOfNode_[neighbour] = own;
        visited_[own].push_back(neighbour);
      } else if (root(group_, seen) != own) {
        merge(root(group_, seen), own);
      }
    });
    const std::uint32_t own = root(group_, s);
    if (!isOpen(own)) closeOne(own);
  }

  void closeOne(std::uint32_t group) {
    const std::uint32_t concern = root(concern_, group);
    count(concern, growing_[concern] - 1);
  }

  /// The smaller list joins the larger. Both were growing: a finished group has no edge to another.
  void merge(std::uint32_t first, std::uint32_t second) {
    joinConcerns(first, second);
    closeOne(first);
    if (visited_[first].size() < visited_[second].size()) std::swap(first, second);
    group_[second] = first;
    std::vector<NodeIndex>& into = visited_[first];
    std::vector<NodeIndex>& from = visited_[second];
    const auto done = static_cast<std::ptrdiff_t>(next_[second]);
    // Expanded nodes of `from` go before the open ones of `into`.
    into.insert(into.begin() + static_cast<std::ptrdiff_t>(next_[first]), from.begin(), from.begin() + done);
    next_[first] += next_[second];
    into.insert(into.end(), from.begin() + done, from.end());
    from.clear();
    next_[second] = 0;
  }

  const BondLayout& layout_;
  std::vector<std::uint32_t>& searchOfNode_;
  std::vector<std::uint32_t> group_;             ///< union-find over seeds
  std::vector<std::uint32_t> concern_;           ///< union-find over seeds
  std::vector<std::uint32_t> growing_;           ///< groups that still grow, by root of a concern
  std::vector<std::vector<NodeIndex>> visited_;  ///< expanded nodes, then open ones
  std::vector<std::size_t> next_;                ///< the first open one
  std::size_t unsettled_ = 0;                    ///< concerns with more than one group that grows
};

bool Components::relabelOne(const BondLayout& layout, std::span<const NodePair> broken, double time) {
  ++relabelings_;
  searchOfNode_.resize(fragmentOfNode_.size(), kNone);
  const FragmentId parent = fragmentOfNode_[broken.front().a];
  Search search(layout, searchOfNode_, broken);
  const auto pieces = search.cutOff();
  for (const std::vector<NodeIndex>& piece : pieces) {
    const auto id = static_cast<FragmentId>(births_.size());
    births_.push_back({parent, time, static_cast<std::uint32_t>(piece.size())});
    births_[parent].nodeCount -= static_cast<std::uint32_t>(piece.size());
    for (const NodeIndex node : piece) fragmentOfNode_[node] = id;
  }
  return !pieces.empty();
}

bool Components::relabel(const BondLayout& layout, std::span<const BreakEvent> events, double time) {
  std::vector<NodePair> broken;
  broken.reserve(events.size());
  for (const BreakEvent& event : events) broken.push_back({event.a, event.b});
  std::sort(broken.begin(), broken.end(), [&](const NodePair& left, const NodePair& right) {
    return std::tuple(of(left.a), left.a, left.b) < std::tuple(of(right.a), right.a, right.b);
  });
  bool born = false;
  for (std::size_t first = 0; first < broken.size();) {
    std::size_t last = first + 1;
    while (last < broken.size() && of(broken[last].a) == of(broken[first].a)) ++last;
    // Labels change while this runs, but only from the fragment just treated to newborn ones behind all
    // others.
    born |= relabelOne(layout, std::span(broken).subspan(first, last - first), time);
    first = last;
  }
  return born;
}

void Components::restore(std::vector<FragmentId> fragmentOfNode, std::vector<FragmentBirth> births,
                         std::uint64_t relabelings) {
  assert(fragmentOfNode.size() == fragmentOfNode_.size());
  fragmentOfNode_ = std::move(fragmentOfNode);
  births_ = std::move(births);
  relabelings_ = relabelings;
}

std::size_t Components::memoryBytes() const {
  return (fragmentOfNode_.capacity() + searchOfNode_.capacity()) * sizeof(std::uint32_t) +
         births_.capacity() * sizeof(FragmentBirth);
}

std::vector<Fragment> describeFragments(const Network& network, const Components& components) {
  std::vector<Fragment> fragments;
  fragments.reserve(components.births().size());
  for (const FragmentBirth& birth : components.births()) {
    const auto id = static_cast<FragmentId>(fragments.size());
    fragments.push_back({id, birth.parent, birth.born, birth.nodeCount, 0.0});
  }
  for (std::size_t node = 0; node < network.nodeCount(); ++node) {
    if (std::isfinite(network.masses[node]))
      fragments[components.fragmentOfNode()[node]].mass += network.masses[node];
  }
  return fragments;
}

std::vector<MovingFragment> describeMotion(const Network& network, const Snapshot& snapshot) {
  const std::vector<Fragment>& fragments = snapshot.broken->fragments;
  const double far = std::numeric_limits<double>::max();
  std::vector<MovingFragment> moving;
  moving.reserve(fragments.size());
  for (const Fragment& fragment : fragments) {
    assert(fragment.id == moving.size());
    moving.push_back({.id = fragment.id, .boxMin = Vec3::Constant(far), .boxMax = Vec3::Constant(-far)});
  }
  for (std::size_t node = 0; node < network.nodeCount(); ++node) {
    MovingFragment& fragment = moving[snapshot.broken->fragmentOfNode[node]];
    const Vec3& position = snapshot.positions[node];
    fragment.boxMin = fragment.boxMin.cwiseMin(position);
    fragment.boxMax = fragment.boxMax.cwiseMax(position);
    const double mass = network.masses[node];
    if (!std::isfinite(mass)) continue;
    fragment.centre += mass * position;
    fragment.velocity += mass * snapshot.velocities[node];
  }
  for (MovingFragment& fragment : moving) {
    const double mass = fragments[fragment.id].mass;
    if (mass > 0.0) {
      fragment.centre /= mass;
      fragment.velocity /= mass;
    } else {
      fragment.centre = 0.5 * (fragment.boxMin + fragment.boxMax);
    }
  }
  return moving;
}

}  // namespace sim
