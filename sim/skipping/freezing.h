#pragma once

#include "sim/world/world.h"

/// Which fragments go on as rigid bodies: those that are strained by nothing to speak of, or for good and
/// still. Such a body is pushed by gentle contacts, until the contact rows, which cover all that can touch
/// before they are built again, say that something nears it too fast.
namespace sim {

/// Makes bodies of fragments that have no strain to speak of. `interval`: s, since this was last asked.
void freezeCalm(World& world, double time, double interval);
/// Finds which nodes of rigid bodies may be pushed, and melts those bodies that are neared too fast.
void meltStruck(World& world, double time);

}  // namespace sim
