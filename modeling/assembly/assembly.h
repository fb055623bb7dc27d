#pragma once

#include <string>
#include <vector>

#include "modeling/glue/glue.h"
#include "modeling/material/material.h"
#include "modeling/shapes/lattice.h"
#include "sim/network/network.h"

/// From lattices, materials and glue to the network's blueprint.
namespace modeling {

/// One part as it stands in the world before gluing.
struct AssemblyPart {
  std::string name;
  Lattice lattice;                 ///< world coordinates
  std::size_t material = 0;        ///< index into the materials
  Vec3 velocity = Vec3::Zero();    ///< cm/s, of every node
  std::vector<std::uint8_t> held;  ///< one a node, nonzero: infinite mass; empty: none is
  // A raw network has lattice.nodes but no cells, and these instead. Their `material` is an index into the
  // materials of the assembly, of which only threshold and plastic flow count; their a and b are nodes of the
  // part.
  std::vector<sim::BlueprintBond> looseBonds;
  std::vector<double> looseMasses;    ///< g, one a node, added to what cells give; empty: none
  std::vector<Vec3> looseVelocities;  ///< cm/s, one a node, added to velocity; empty: none
};

/// Makes one network of the parts.
/// - Nodes stand in the order of `glue`; a merged node has the position, velocity, part and material of the
/// part it
///   was merged into, and the mass of all. A cell gives each of its corners an eighth of density * volume.
/// - Each cell is fitted as it is after gluing (bond_fit.h); cells give to a bond one after the other in
/// their order,
///   and the bond gets the material of the cell that gives most. A pair both of whose nodes one glue merged
///   gets nothing from its cell (paper, "Geometric modeling": set to zero, so as not to duplicate bonds).
/// - A cell that gluing gave a repeated corner or no volume keeps its bonds, with the stiffness and mass it
/// had
///   before gluing, and stops being a cell.
/// - blueprint.materials starts with one entry for each of `materials`, in order, for the cell size of the
/// first
///   part made of it; parts whose cell size asks for another threshold use variants of the same name behind
///   those.
/// A Problem's place is "parts[i]" or "materials[i].key".
sim::Result<sim::Blueprint> assemble(const std::vector<AssemblyPart>& parts,
                                     const std::vector<Material>& materials, const GlueResult& glue);

}  // namespace modeling
