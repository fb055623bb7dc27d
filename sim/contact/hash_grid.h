#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/state/motion.h"

namespace sim {

/// Space cut into cubes, kept in a hash table (paper, "Collision detection"). Each cube is tagged with
/// the fragment its nodes belong to, or as mixed, so that cubes of one fragment only are never compared. Cost
/// linear in nodes.
class HashGrid {
 public:
  /// Sorts these nodes into cubes of the given edge (cm). `fragmentOfNode` gives the tags.
  void build(const NodeVectors& positions, std::span<const NodeIndex> nodes,
             std::span<const FragmentId> fragmentOfNode, double edge);

  /// Calls visit(i, j), i != j, for each pair of nodes of which one is in cube `index` and the other in the
  /// same or a touching cube, unless both cubes hold one and the same fragment only and `withinFragments` is
  /// false. Over all cubes, each unordered pair is visited once.
  template <class Visit>
  void forEachPairOf(std::size_t index, bool withinFragments, Visit&& visit) const {
    const Cube& cube = cubes_[index];
    if (withinFragments || cube.tag == kMixed) {
      for (std::uint32_t i = cube.first; i < cube.last; ++i) {
        for (std::uint32_t j = i + 1; j < cube.last; ++j) visit(nodes_[i], nodes_[j]);
      }
    }
    for (const auto& step : kForward) {
      const std::uint32_t other = find(shifted(cube.at, step));
      if (other == kNone) continue;
      const Cube& there = cubes_[other];
      if (!withinFragments && cube.tag == there.tag && cube.tag != kMixed) continue;
      for (std::uint32_t i = cube.first; i < cube.last; ++i) {
        for (std::uint32_t j = there.first; j < there.last; ++j) visit(nodes_[i], nodes_[j]);
      }
    }
  }

  std::size_t cubeCount() const { return cubes_.size(); }
  std::size_t memoryBytes() const;

 private:
  /// Three cube coordinates of 21 bits each. Cubes two million apart share a place, which costs comparisons,
  /// not truth.
  using Place = std::uint64_t;
  struct Cube {
    Place at;
    FragmentId tag;
    std::uint32_t first = 0;  ///< nodes_[first, last)
    std::uint32_t last = 0;
  };
  static constexpr FragmentId kMixed = kNone;
  /// Half of the 26 neighbours; the other half sees this cube as theirs.
  static constexpr std::array<std::array<std::int64_t, 3>, 13> kForward{{{1, 0, 0},
                                                                         {-1, 1, 0},
                                                                         {0, 1, 0},
                                                                         {1, 1, 0},
                                                                         {-1, -1, 1},
                                                                         {0, -1, 1},
                                                                         {1, -1, 1},
                                                                         {-1, 0, 1},
                                                                         {0, 0, 1},
                                                                         {1, 0, 1},
                                                                         {-1, 1, 1},
                                                                         {0, 1, 1},
                                                                         {1, 1, 1}}};
  static constexpr int kBits = 21;
  static constexpr std::uint64_t kMask = (1ULL << kBits) - 1;

  static Place placeOf(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
    return (x & kMask) | (y & kMask) << kBits | (z & kMask) << (2 * kBits);
  }
  /// Unsigned, so that coordinates wrap round where signed ones would overflow.
  static Place shifted(Place at, const std::array<std::int64_t, 3>& step) {
    return placeOf(at + static_cast<std::uint64_t>(step[0]),
                   (at >> kBits) + static_cast<std::uint64_t>(step[1]),
                   (at >> (2 * kBits)) + static_cast<std::uint64_t>(step[2]));
  }

  std::uint32_t find(Place at) const;
  std::uint32_t findOrAdd(Place at, FragmentId tag);

  std::vector<std::uint32_t> table_;  ///< open addressing; indices of cubes_, kNone where free
  std::vector<Cube> cubes_;           ///< in order of their first node
  std::vector<NodeIndex> nodes_;
  std::vector<std::uint32_t> cubeOfNode_;
};

}  // namespace sim
