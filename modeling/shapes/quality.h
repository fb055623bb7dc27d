#pragma once

#include <cstddef>

#include "modeling/shapes/lattice.h"

namespace modeling {

/// How good a lattice's cells are. Narrow cells make the step small and let things pass between their nodes
/// (paper, "Collision detection": "it is very important to construct uniform or nearly uniform grids").
struct LatticeQuality {
  double minScaledJacobian = 0.0;   ///< over all corners of all cells; 1: a cube, <= 0: inverted
  double meanScaledJacobian = 0.0;  ///< mean over the cells of each cell's smallest
  sim::CellIndex mostSkewedCell = sim::kNone;
  double maxAspect = 0.0;  ///< longest over shortest edge of a cell
  double meanAspect = 0.0;
  sim::CellIndex longestCell = sim::kNone;  ///< the cell of the largest aspect
  double minEdge = 0.0;                     ///< cm; edges counted once a cell
  double meanEdge = 0.0;
  double maxEdge = 0.0;
  double volume = 0.0;  ///< cm^3
};

LatticeQuality measure(const Lattice& lattice);

/// Positions of a cell's corners, in CellCorners order.
using CornerPositions = std::array<Vec3, 8>;

CornerPositions cornerPositions(const std::vector<Vec3>& nodes, const sim::CellCorners& cell);

/// The smallest, over the corners, of the triple product of the three unit edges that leave it.
double scaledJacobian(const CornerPositions& corners);

/// Likewise of a wedge (sim/network/wedge.h): over the corners that three edges leave to three places; 0
/// where there is none.
double scaledJacobianOfWedge(const CornerPositions& corners);

/// Longest over shortest edge.
double cellAspect(const CornerPositions& corners);

/// Volume of the trilinear cell, cm^3; negative where it is inside out.
double cellVolume(const CornerPositions& corners);

}  // namespace modeling
