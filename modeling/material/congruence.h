#pragma once

#include <cstdint>
#include <vector>

#include "modeling/shapes/lattice.h"

namespace modeling {

/// Two cells are congruent when all 28 distances between their corners agree to this share of the cell's
/// size: far above the rounding of positions, far below any shape a person would tell apart.
inline constexpr double kCongruence = 1e-9;

/// Cells sorted by shape (a mirror image is another one). The same whatever moves or turns a cell, so that
/// what is computed once for each shape is the same to the last bit for all its cells.
struct Congruence {
  std::vector<sim::CellIndex> representatives;  ///< of each class, its first cell; ascending
  std::vector<std::uint32_t> classOfCell;
};

/// `marks`, one a cell, keep cells of different marks in different classes.
Congruence congruentCells(const std::vector<Vec3>& nodes, const std::vector<sim::CellCorners>& cells,
                          const std::vector<std::uint8_t>& marks);

}  // namespace modeling
