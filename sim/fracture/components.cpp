#include "sim/fracture/components.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

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

/// Searches that grow in turns inside one old fragment, one a seed.
class Components::Search {
 public:
  Search(const BondLayout& layout, std::vector<std::uint32_t>& searchOfNode, std::span<const NodeIndex> seeds)
      : layout_(layout),
        searchOfNode_(searchOfNode),
        group_(seeds.size()),
        visited_(seeds.size()),
        next_(seeds.size(), 0) {
    std::iota(group_.begin(), group_.end(), 0U);
    for (std::uint32_t s = 0; s < seeds.size(); ++s) {
      searchOfNode_[seeds[s]] = s;
      visited_[s].push_back(seeds[s]);
    }
    growing_ = seeds.size();
    while (growing_ > 1) {
      for (std::uint32_t s = 0; s < group_.size() && growing_ > 1; ++s) {
        if (group_[s] == s && next_[s] < visited_[s].size()) expand(s);
      }
    }
  }

  /// The groups that are whole components and not the one that keeps the old id, each with its nodes, by
  /// first seed.
  std::vector<std::vector<NodeIndex>> cutOff() {
    std::uint32_t keeper = kNone;
    for (std::uint32_t s = 0; s < group_.size(); ++s) {
      if (group_[s] != s) continue;
      const bool unfinished = next_[s] < visited_[s].size();
      const bool larger = keeper == kNone || visited_[s].size() > visited_[keeper].size();
      if (unfinished || (growing_ == 0 && larger)) keeper = s;
    }
    std::vector<std::vector<NodeIndex>> pieces;
    for (std::uint32_t s = 0; s < group_.size(); ++s) {
      for (const NodeIndex node : visited_[s]) searchOfNode_[node] = kNone;
      if (group_[s] == s && s != keeper) pieces.push_back(std::move(visited_[s]));
    }
    return pieces;
  }

 private:
  std::uint32_t root(std::uint32_t search) {
    while (group_[search] != search) search = group_[search] = group_[group_[search]];
    return search;
  }

  /// Visits the neighbours of one node of group `s`.
  void expand(std::uint32_t s) {
    const NodeIndex node = visited_[s][next_[s]++];
    layout_.forEachNeighbour(node, [&](NodeIndex neighbour) {
      const std::uint32_t seen = searchOfNode_[neighbour];
      if (seen == kNone) {
        const std::uint32_t own = root(s);
        searchOfNode_[neighbour] = own;
        visited_[own].push_back(neighbour);
      } else if (root(seen) != root(s)) {
        merge(root(seen), root(s));
      }
    });
    const std::uint32_t own = root(s);
    if (next_[own] == visited_[own].size()) --growing_;
  }

  /// The smaller list joins the larger. Both were growing: a finished group has no edge to another.
  void merge(std::uint32_t first, std::uint32_t second) {
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
    --growing_;
  }

  const BondLayout& layout_;
  std::vector<std::uint32_t>& searchOfNode_;
  std::vector<std::uint32_t> group_;             ///< union-find over seeds
  std::vector<std::vector<NodeIndex>> visited_;  ///< expanded nodes, then open ones
  std::vector<std::size_t> next_;                ///< the first open one
  std::size_t growing_ = 0;
};

bool Components::relabelOne(const BondLayout& layout, std::span<const NodeIndex> seeds, double time) {
  ++relabelings_;
  searchOfNode_.resize(fragmentOfNode_.size(), kNone);
  const FragmentId parent = fragmentOfNode_[seeds.front()];
  Search search(layout, searchOfNode_, seeds);
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
  std::vector<NodeIndex> ends;
  ends.reserve(2 * events.size());
  for (const BreakEvent& event : events) {
    ends.push_back(event.a);
    ends.push_back(event.b);
  }
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::stable_sort(ends.begin(), ends.end(),
                   [&](NodeIndex left, NodeIndex right) { return of(left) < of(right); });
  bool born = false;
  for (std::size_t first = 0; first < ends.size();) {
    std::size_t last = first + 1;
    while (last < ends.size() && of(ends[last]) == of(ends[first])) ++last;
    // Labels change while this runs, but only from the fragment just treated to newborn ones behind all
    // others.
    born |= relabelOne(layout, std::span(ends).subspan(first, last - first), time);
    first = last;
  }
  return born;
}

void Components::labelAgain(const BondLayout& layout) {
  ++relabelings_;
  std::vector<std::uint8_t> seen(fragmentOfNode_.size(), 0);
  std::vector<NodeIndex> open;
  for (NodeIndex start = 0; start < fragmentOfNode_.size(); ++start) {
    if (seen[start] != 0) continue;
    const FragmentId id = fragmentOfNode_[start];
    seen[start] = 1;
    open.assign(1, start);
    while (!open.empty()) {
      const NodeIndex node = open.back();
      open.pop_back();
      assert(fragmentOfNode_[node] == id);
      fragmentOfNode_[node] = id;
      layout.forEachNeighbour(node, [&](NodeIndex neighbour) {
        if (seen[neighbour] != 0) return;
        seen[neighbour] = 1;
        open.push_back(neighbour);
      });
    }
  }
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

std::vector<Fragment> describeFragments(const Network& network, const Components& components,
                                        const Snapshot& snapshot) {
  std::vector<Fragment> fragments(components.births().size());
  const double far = std::numeric_limits<double>::max();
  for (FragmentId id = 0; id < fragments.size(); ++id) {
    const FragmentBirth& birth = components.births()[id];
    fragments[id] = {
        id,           birth.parent, birth.born,          birth.nodeCount,      0.0,
        Vec3::Zero(), Vec3::Zero(), Vec3::Constant(far), Vec3::Constant(-far), FragmentState::deforming};
  }
  for (std::size_t node = 0; node < network.nodeCount(); ++node) {
    Fragment& fragment = fragments[components.fragmentOfNode()[node]];
    const Vec3& position = snapshot.positions[node];
    fragment.boxMin = fragment.boxMin.cwiseMin(position);
    fragment.boxMax = fragment.boxMax.cwiseMax(position);
    const double mass = network.masses[node];
    if (!std::isfinite(mass)) continue;
    fragment.mass += mass;
    fragment.centre += mass * position;
    fragment.velocity += mass * snapshot.velocities[node];
  }
  for (Fragment& fragment : fragments) {
    if (fragment.mass > 0.0) {
      fragment.centre /= fragment.mass;
      fragment.velocity /= fragment.mass;
    } else {
      fragment.centre = 0.5 * (fragment.boxMin + fragment.boxMax);
    }
  }
  return fragments;
}

}  // namespace sim
