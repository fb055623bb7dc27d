#pragma once

#include <span>

#include "sim/world/world.h"

/// How fragments go from one state to another (FragmentState), with their nodes, their energy and the counts
/// of bonds. States that were set take effect on the lattice by refreshStates().
namespace sim {

/// The fragment moves as this rigid body from now on. What it vibrated is dissipated.
void makeRigid(World& world, RigidBody body);
/// The fragment of a rigid body deforms again. The body is left to the caller to erase.
void melt(World& world, const RigidBody& body, double time);
/// A fragment with this much energy of motion (erg) stands still from now on.
void putToSleep(World& world, FragmentId fragment, double kineticEnergy);
/// A sleeping fragment deforms again.
void wake(World& world, FragmentId fragment, double time);
void wakeIfAsleep(World& world, FragmentId fragment, double time);

/// Forces are about to change everywhere.
void wakeEverything(World& world, double time);
void meltEverything(World& world, double time);
/// The rigid ones among these fragments deform again.
void meltFragments(World& world, std::span<const FragmentId> fragments, double time);

/// After a look in vain, the next look at a fragment waits twice as long as the one before.
void waitLonger(FragmentRecord& record);
/// Takes nodes out of the lattice, where they stand still, or puts them back.
void holdNodes(World& world, std::span<const NodeIndex> nodes);
void releaseNodes(World& world, std::span<const NodeIndex> nodes);
/// Brings lanes and blocks up to the states that were set.
void refreshStates(World& world);

}  // namespace sim
