#pragma once

#include <span>

#include "sim/base/parallel.h"
#include "sim/world/world.h"

/// Forces on the nodes of a World, at its own moment or at a trial state.
namespace sim {

/// Points a kernel step at the lattice, the state it starts from and the one it writes; vectors of `to` that
/// are empty are not written. Kick and drift are left to the caller.
KernelStep kernelStep(const World& world, const Motion& from, Motion& to);
/// Steps the blocks that deform. `reports` has one for each block.
void runKernel(const World& world, const KernelStep& step, std::vector<BlockReport>& reports);
/// erg, by the reports of the last kernel run over the blocks that deform
double dissipatedBy(const World& world, const std::vector<BlockReport>& reports);

/// What contacts see of this moment. `kick`: s, how long the forces act.
ContactMoment contactMoment(const World& world, double kick);
/// Sets the forces of contacts at this moment.
ColliderWork findContactForcesNow(const World& world, double kick, ContactForces& forces);

/// The force of the bond that joins two nodes on the first of them, dyn: as in the kernel.
Vec3 bondForce(const World& world, const Motion& at, NodeIndex node, NodeIndex neighbour);
/// What whoever carries held nodes along does against the forces on them during a kick (s), erg.
double carryingWork(const World& world, const Motion& at, const ContactForces& forces, double kick);

/// Stretch of a bond over its rest length, minus 1.
double strainIn(const World& world, const Motion& motion, BondIndex bond);
/// cm/s: no node is faster; zero where all is still
double fastestSpeed(const World& world);

}  // namespace sim
