#pragma once

#include <vector>

#include "modeling/assembly/contributions.h"

namespace modeling {

/// What each part needs of its material.
struct PartConstants {
  sim::MaterialIndex material = 0;
  double youngsModulus = 0.0;  ///< dyn/cm^2
  double dampingTime = 0.0;    ///< s
};

/// One bond a pair of nodes, by first, then second node, with what all cells, in their order, and then all
/// loose bonds give it. Runs on all threads; the result doesn't depend on how many. looseBonds: by first
/// node. constants: one a part.
std::vector<sim::BlueprintBond> addUpBonds(const std::vector<Vec3>& positions,
                                           const std::vector<GivingCell>& cells,
                                           const std::vector<GivingBond>& looseBonds,
                                           const std::vector<PartConstants>& constants);

}  // namespace modeling
