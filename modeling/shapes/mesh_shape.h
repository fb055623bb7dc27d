#pragma once

#include <string>

#include "modeling/shapes/lattice.h"
#include "sim/collider/triangle_mesh.h"

namespace modeling {

/// What a length of 1 in a file means. Some formats say so; where one does not, a guess is the unit in which
/// the thing would have a size that dishware has.
enum class MeshUnit { guess, millimetre, centimetre, metre, inch };

/// Which axis of a file points up. A guess is what the format is usually written in.
enum class MeshUp { guess, y, z };

/// A mesh in a file, and how to take it.
struct MeshSource {
  std::string file;  ///< relative to the scene's folder
  MeshUnit unit = MeshUnit::guess;
  MeshUp up = MeshUp::guess;

  bool operator==(const MeshSource&) const = default;
};

/// A closed mesh filled with cells that end at its surface.
struct MeshShape {
  std::string file;  ///< see MeshSource
  MeshUnit unit = MeshUnit::guess;
  MeshUp up = MeshUp::guess;
  double cellSize = 0.5;  ///< cm, > 0

  MeshSource source() const { return {file, unit, up}; }

  bool operator==(const MeshShape&) const = default;
};

/// How well a lattice fills a mesh.
struct MeshFit {
  double volumeShare = 0.0;    ///< volume of the cells over that of the mesh
  double farthest = 0.0;       ///< cm: of the lattice's outer nodes from the mesh
  std::size_t addedCells = 0;  ///< where the lattice would have hung together by an edge or a corner only
  sim::TriangleMesh::Crossings crossings;  ///< of the mesh with itself
};

/// Cells of a cubic grid of which the mesh holds at least half, with their outer nodes moved onto the mesh
/// and its sharp edges and corners, and the others evened out, as far as no cell gets badly skewed by it. A
/// Problem's place is a key of MeshShape: the mesh is not closed, a cell is larger than the mesh is thick
/// everywhere, or there would be too many. `parameters` are the shares of the mesh's box.
sim::Result<Lattice> fillMesh(const sim::TriangleMesh& mesh, double cellSize, MeshFit& fit);

}  // namespace modeling
