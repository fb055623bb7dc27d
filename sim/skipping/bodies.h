#pragma once

#include <span>
#include <vector>

#include "sim/world/world.h"

/// How rigid bodies move along with the lattice.
namespace sim {

/// Carries the rigid bodies through a step: kicked by gravity and contacts for `kick` s, moved for `drift` s.
/// Takes what pushes their nodes out of world.forces; returns the work against friction and contact damping,
/// erg. `byOldVelocity`: they drift by the velocity that they had before the kick.
double moveBodies(World& world, double kick, double drift, bool byOldVelocity);

/// How the rigid bodies move with gravity and contacts for `kick` s more. Takes their forces out, and adds
/// the work against friction and contact damping (erg) to `dissipated`.
std::vector<RigidBody::Rates> ratesAfter(const World& world, double kick, ContactForces& forces,
                                         double& dissipated);
/// Writes the velocities of the nodes of all bodies, which move at these rates.
void placeVelocities(const World& world, NodeVectors& velocities, std::span<const RigidBody::Rates> rates);

/// Some rigid body may be pushed.
bool anyTouched(const World& world);
/// Puts the nodes that contacts may push where they are. After every step, and when rows are new.
void placeTouched(World& world);
/// Puts all nodes of rigid bodies where they are. To be called before anyone looks at positions.
void placeBodies(World& world);
/// No node of a rigid body is faster, cm/s.
double fastestBody(const World& world);

}  // namespace sim
