#pragma once

#include <vector>

#include "sim/network/network.h"

namespace sim {

/// A quadrilateral of the polygonal surface (paper, "Rendering"): a face of an unbroken cell that no other
/// unbroken cell shares. Counter-clockwise seen from outside.
struct SurfaceFace {
  std::array<NodeIndex, 4> nodes;
  CellIndex cell = kNone;
  bool fracture = false;  ///< shared by two cells when everything was whole: the inside of the material shows
};

/// All surface faces, in order of their cells. brokenCells: one byte a cell, nonzero where broken; empty
/// means none is.
std::vector<SurfaceFace> surfaceFaces(const Network& network, const std::vector<std::uint8_t>& brokenCells);

}  // namespace sim
