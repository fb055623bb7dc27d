#pragma once

#include "sim/world/world.h"

/// Nodes do not get through colliders. What springs do not stop, a force does that is just large enough: it
/// is found before the step, from all other forces on the node, and then is one of them, so that it is
/// accounted for like friction (docs/numerics.md, "Colliders that hold").
namespace sim {

/// For methods that kick velocities and then drift positions: adds the stopping forces to world.forces, and
/// notes the rigid pieces that a stop is to hold in world.stopped. `kick`: s, how long forces act in this
/// step. `byOldVelocity`: nodes drift by the velocity that they had before the kick.
void stopAtColliders(World& world, double kick, bool byOldVelocity);

/// Lets the pieces of world.stopped deform, since what is held must give way where it is held.
void meltStopped(World& world);

/// For methods that make a step as a whole: stops nodes that went too deep where they did, after the step of
/// `length` s from world.now to world.next. `accelerations` are those at its end, cm/s^2. True when a node
/// was stopped.
bool stopAfterStep(World& world, const NodeVectors& accelerations, double length);

}  // namespace sim
