#pragma once

#include <vector>

#include "sim/state/tangent.h"
#include "sim/world/world.h"

namespace sim {

/// The right-hand side of the equations of motion at one state: x' = v, v' = a(x, v), and beside them the two
/// flows of energy that the ledger asks for, which are integrated like everything else.
struct Rates {
  NodeVectors acceleration;  ///< cm/s^2; zero for held nodes
  double dissipated = 0.0;   ///< erg/s, by dampers and friction
  double outsideWork = 0.0;  ///< erg/s, by colliders that move and held nodes that are carried along
};

/// At a state `ahead` seconds after the World's moment; colliders go on at the velocity they have. `kick`: s,
/// how long friction acts. Uses world.forces and world.reports, and counts the work.
void ratesAt(World& world, const Motion& at, double ahead, double kick, Rates& rates);

/// Replaces the list by the tangents at the state whose rates were last asked for: bonds in their order, then
/// contacts.
void tangentsAt(const World& world, const Motion& at, double ahead, double kick,
                std::vector<Tangent>& tangents);

}  // namespace sim
