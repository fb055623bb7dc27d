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
  // part. At most one bond a pair.
  std::vector<sim::BlueprintBond> looseBonds;
  std::vector<double> looseMasses;    ///< g, one a node, added to what cells give; empty: none
  std::vector<Vec3> looseVelocities;  ///< cm/s, one a node, added to velocity; empty: none
};

/// Makes one network of the parts.
/// - Nodes stand in the order of `glue`; a merged node has the position, velocity, part and material of the
///   part it was merged into, and the mass of all. A cell gives each of its corners an eighth of
///   density * volume.
/// - Each cell is fitted as it is after gluing (bond_fit.h), with damping d = beta k, beta for the mean cell
/// of
///   its part. What several cells and loose bonds give one pair is added in their order; the bond gets the
///   material of the first that gives most, and cells' bonds are as long as their nodes are apart.
/// - A pair both of whose nodes one glue merged gets nothing from its cell (paper, "Geometric modeling": set
/// to
///   zero, so as not to duplicate bonds).
/// - A cell that gluing dropped keeps what bonds it has left, as stiff as before gluing, and the mass of the
///   volume it has left; it is no cell of the network.
/// - blueprint.materials starts with one entry for each of `materials`, in order; where parts of different
/// cell
///   size need different thresholds of one material, further entries of the same name stand behind those.
/// A Problem's place is "parts[i]" or "materials[i].key".
sim::Result<sim::Blueprint> assemble(const std::vector<AssemblyPart>& parts,
                                     const std::vector<Material>& materials, const GlueResult& glue);

}  // namespace modeling
