#pragma once

#include "sim/world/world.h"

/// Where the energy of a World is (docs/numerics.md, "Energy").
namespace sim {

/// What velocities and flows are at the moment of the positions, where a method keeps them half a kick
/// behind.
struct Present {
  NodeVectors velocity;      ///< cm/s
  double dissipated = 0.0;   ///< erg, within that half kick
  double outsideWork = 0.0;  ///< erg, within that half kick
};

/// erg, in intact bonds
double elasticEnergy(const World& world);
/// erg, in bonds, contacts and colliders
double potentialEnergy(const World& world);
/// The account at this moment.
LedgerRow drawAccount(const World& world, const Present& present);

}  // namespace sim
