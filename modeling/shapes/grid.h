#pragma once

#include <array>
#include <functional>

#include "modeling/shapes/lattice.h"

namespace modeling {

/// Where a node goes, by its shares (u, v, w) of the three axes.
using PlaceNode = std::function<Vec3(const Vec3& shares)>;

/// A lattice that is one regular grid of cells: slab, patch, open revolution, swept rectangle, ring or arc.
struct GridLayout {
  std::array<int, 3> cells{1, 1, 1};  ///< along u, v, w
  std::array<bool, 3> wraps{};        ///< the last column of nodes is the first
};

/// Nodes along an axis.
int nodesAlong(const GridLayout& layout, std::size_t axis);

/// Node order: the axis with the most nodes innermost, the one with the fewest next, so that neighbours
/// across the remaining axis are as near in memory as they can be. Not yet completed().
Lattice gridLattice(const GridLayout& layout, const PlaceNode& place);

}  // namespace modeling
