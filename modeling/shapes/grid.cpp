#include "modeling/shapes/grid.h"

#include <algorithm>
#include <cstddef>

namespace modeling {
namespace {

using Index3 = std::array<int, 3>;

/// Axes from the innermost to the outermost.
std::array<std::size_t, 3> axisOrder(const GridLayout& layout) {
  std::array<std::size_t, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](std::size_t a, std::size_t b) {
    return nodesAlong(layout, a) > nodesAlong(layout, b);
  });
  std::swap(axes[1], axes[2]);
  return axes;
}

/// Calls visit(index) for all indices below `ends`, the first of `axes` fastest.
template <class Visit>
void forEachIndex(const Index3& ends, const std::array<std::size_t, 3>& axes, const Visit& visit) {
  Index3 at{};
  for (at[axes[2]] = 0; at[axes[2]] < ends[axes[2]]; ++at[axes[2]])
    for (at[axes[1]] = 0; at[axes[1]] < ends[axes[1]]; ++at[axes[1]])
      for (at[axes[0]] = 0; at[axes[0]] < ends[axes[0]]; ++at[axes[0]]) visit(at);
}

}  // namespace

int nodesAlong(const GridLayout& layout, std::size_t axis) {
  return layout.cells[axis] + (layout.wraps[axis] ? 0 : 1);
}

Lattice gridLattice(const GridLayout& layout, const PlaceNode& place) {
  const auto axes = axisOrder(layout);
  Index3 ends{}, strides{};
  for (std::size_t axis = 0; axis < 3; ++axis) ends[axis] = nodesAlong(layout, axis);
  strides[axes[0]] = 1;
  strides[axes[1]] = ends[axes[0]];
  strides[axes[2]] = ends[axes[0]] * ends[axes[1]];

  Lattice lattice;
  const auto nodeCount = static_cast<std::size_t>(strides[axes[2]]) * static_cast<std::size_t>(ends[axes[2]]);
  lattice.nodes.reserve(nodeCount);
  lattice.parameters.reserve(nodeCount);
  forEachIndex(ends, axes, [&](const Index3& at) {
    Vec3 shares;
    for (std::size_t axis = 0; axis < 3; ++axis)
      shares[static_cast<Eigen::Index>(axis)] =
          static_cast<double>(at[axis]) / static_cast<double>(layout.cells[axis]);
    lattice.parameters.push_back(shares);
    lattice.nodes.push_back(place(shares));
  });

  forEachIndex(layout.cells, axes, [&](const Index3& at) {
    sim::CellCorners cell;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      int node = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
        node += strides[axis] * ((at[axis] + static_cast<int>((corner >> axis) & 1U)) % ends[axis]);
      cell[corner] = static_cast<sim::NodeIndex>(node);
    }
    lattice.cells.push_back(cell);
  });
  return lattice;
}

}  // namespace modeling
