#pragma once

#include <cstdint>
#include <vector>

#include "modeling/shapes/lattice.h"

namespace modeling {

/// Two-colours the nodes along the cells' edges and tells for each cell whether its corner 0 is of the second
/// colour. Where a ring of an odd number of cells allows no two-colouring, the cells along one seam disagree
/// with their neighbours.
std::vector<std::uint8_t> checkerboard(const std::vector<sim::CellCorners>& cells, std::size_t nodeCount);

}  // namespace modeling
