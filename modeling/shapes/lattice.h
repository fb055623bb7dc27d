#pragma once

#include <vector>

#include "sim/base/result.h"
#include "sim/network/network.h"

/// Authoring: shapes, gluing, materials, scenes. Units as in sim: cm, g, s; z up.
namespace modeling {

using sim::Vec3;

/// What every shape is turned into: nodes in lattice order (the longest axis innermost) and hexahedral cells.
/// Invariants: every cell has positive volume and a positive Jacobian at its corners; no node is without a
/// cell; two cells that touch share nodes (conforming). A raw network is no lattice: it has no cells.
struct Lattice {
  std::vector<Vec3> nodes;  ///< part coordinates, cm
  std::vector<sim::CellCorners> cells;
  std::vector<Vec3> parameters;  ///< the shape's own (u, v, w) in [0, 1]^3 at each node: texture coordinates
};

/// Turns every cell the other way round (left-handed to right-handed).
void mirror(std::vector<sim::CellCorners>& cells);

/// Last step of every shape: a lattice laid out left-handed throughout is made right-handed. Problem where a
/// cell is flat or turned inside out, or a node is not finite; `remedy` says what of the shape to change.
sim::Result<Lattice> completed(Lattice lattice, const std::string& remedy);

}  // namespace modeling
