#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "modeling/shapes/lattice.h"

namespace sim {
class TriangleMesh;
}

namespace modeling {

/// Cells of a cubic grid, some of them filled.
struct CellGrid {
  Vec3 corner = Vec3::Zero();        ///< cm
  double cellSize = 1.0;             ///< cm
  std::array<int, 3> count{};        ///< cells along x, y, z
  std::vector<std::uint8_t> filled;  ///< x innermost
  std::size_t added = 0;             ///< cells that are only filled so that the others hang together
  /// What the mesh has inside, over the same counted as often as it is inside; 1 where nothing is twice. By
  /// sampling.
  double onceShare = 1.0;

  bool holds(const std::array<int, 3>& cell) const {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (cell[axis] < 0 || cell[axis] >= count[axis]) return false;
    return true;
  }
  std::size_t index(const std::array<int, 3>& cell) const {
    return (static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(count[1]) +
            static_cast<std::size_t>(cell[1])) *
               static_cast<std::size_t>(count[0]) +
           static_cast<std::size_t>(cell[0]);
  }
  bool isFilled(const std::array<int, 3>& cell) const { return holds(cell) && filled[index(cell)] != 0; }
};

/// Fills the cells of which the closed mesh holds at least half. Then adds cells, those first of which it
/// holds most, until at every corner the filled cells hang together by faces, as do the others: so that the
/// surface of the cells is one sheet everywhere. The grid has an empty rim.
sim::Result<CellGrid> cellsOf(const sim::TriangleMesh& mesh, double cellSize);

}  // namespace modeling
