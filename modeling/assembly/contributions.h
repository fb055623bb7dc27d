#pragma once

#include <vector>

#include "modeling/assembly/assembly.h"
#include "modeling/material/bond_fit.h"

/// What each part's cells give to the network, before it is added up.
namespace modeling {

/// One part's cells, fitted.
struct FittedPart {
  BondFit fit;
  double cellSize = 0.0;  ///< cm: edge of a cube of the cells' mean volume; of a raw network, its mean bond
  std::vector<std::uint8_t> dropped;   ///< one a cell: no cell of the network
  std::vector<std::uint8_t> asBefore;  ///< one a cell: fitted as before gluing
};

/// A cell in the merged network, ready to give.
struct GivingCell {
  sim::CellCorners corners{};  ///< merged nodes; some may be equal
  std::uint32_t bonds = 0;     ///< pairs that get something, one bit each
  const CellShape* shape = nullptr;
  double mass = 0.0;  ///< g, for each corner
  std::uint32_t part = 0;
};

/// A loose bond between merged nodes, first < second.
struct GivingBond {
  sim::BlueprintBond bond;
  std::uint32_t part = 0;
};

/// Fits the part's cells between the merged nodes; dropped and misshapen ones as they were before. Problem: a
/// cell without volume.
sim::Result<FittedPart> fitPart(const AssemblyPart& part, const Material& material,
                                const std::vector<Vec3>& mergedPositions, const GlueResult& glue,
                                std::size_t index);

/// All cells of all parts in order.
std::vector<GivingCell> givingCells(const std::vector<AssemblyPart>& parts,
                                    const std::vector<Material>& materials,
                                    const std::vector<FittedPart>& fitted, const GlueResult& glue,
                                    const std::vector<Vec3>& mergedPositions);

/// All loose bonds that gluing leaves, by first node, then in order.
std::vector<GivingBond> givingBonds(const std::vector<AssemblyPart>& parts, const GlueResult& glue);

}  // namespace modeling
