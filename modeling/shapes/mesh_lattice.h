#pragma once

#include <cstddef>

#include "modeling/shapes/lattice.h"
#include "sim/base/result.h"
#include "sim/collider/mesh_crossings.h"

namespace sim {
class TriangleMesh;
}

namespace modeling {

/// How well a lattice fills a mesh.
struct MeshFit {
  double volumeShare = 0.0;  ///< volume of the cells over that of the mesh, counted once where bodies overlap
  double onceShare = 1.0;    ///< below 1: the mesh has something inside more than once (CellGrid)
  double farthest = 0.0;     ///< cm: of the lattice's outer nodes from the mesh
  std::size_t addedCells = 0;    ///< where the lattice would have hung together by an edge or a corner only
  sim::MeshCrossings crossings;  ///< of the mesh with itself
};

/// Cells of a cubic grid of which the mesh holds at least half, with their outer nodes moved onto the mesh
/// and its sharp edges and corners, and the others evened out, as far as no cell gets badly skewed by it. A
/// Problem's place is a key of MeshShape: the mesh is not closed, a cell is larger than the mesh is thick
/// everywhere, or there would be too many. `parameters` are the shares of the mesh's box.
sim::Result<Lattice> fillMesh(const sim::TriangleMesh& mesh, double cellSize, MeshFit& fit);

}  // namespace modeling
