#pragma once

#include <vector>

#include "sim/skipping/fragment_sums.h"

/// Which fragments sleep. An asleep fragment was still for so long that it could have fallen, and everything
/// heavy next to it was, too. It stands where it is, with its strain, until something next to it moves that
/// could move it, a collider next to it moves, or gravity or a stiffness changes.
namespace sim {

/// Lists the fragments that may touch, and how fast they near each other.
void noteNeighbours(World& world, const std::vector<FragmentSums>& sums);
/// What is still for long enough sleeps, unless something nears it that could move it.
void fallAsleep(World& world, const std::vector<FragmentSums>& sums, double time);
/// What nears a sleeper, and could give it more than the speed of rest, wakes it. So does what goes away from
/// it, since it may have held it up.
void wakeByContact(World& world, const std::vector<FragmentSums>& sums, double time);
/// Colliders have moved, or begun to act: those that sleep next to them wake.
void wakeByColliders(World& world, double time);

}  // namespace sim
