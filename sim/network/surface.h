#pragma once

#include <array>
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

/// Which faces of the cells coincide. Depends on the network alone: made once, it yields the surface of every
/// frame. Building and asking are linear in the number of cells.
class CellFaces {
 public:
  explicit CellFaces(const Network& network);

  /// All surface faces, in order of their cells. brokenCells: one byte a cell, nonzero where broken; empty
  /// means none is.
  std::vector<SurfaceFace> surface(const std::vector<std::uint8_t>& brokenCells) const;

 private:
  bool isInterior(std::uint32_t face, const std::vector<std::uint8_t>& brokenCells) const;

  std::vector<CellCorners> cells_;
  std::vector<std::uint32_t> twins_;  ///< face 6 cell + side -> next face of the same four nodes, in a ring
};

/// The surface of one moment; CellFaces saves work where many are asked for.
std::vector<SurfaceFace> surfaceFaces(const Network& network, const std::vector<std::uint8_t>& brokenCells);

}  // namespace sim
