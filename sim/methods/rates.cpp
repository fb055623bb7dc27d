#include "sim/methods/rates.h"

#include <algorithm>

#include "sim/contact/contact_tangents.h"
#include "sim/world/forces.h"

namespace sim {

void ratesAt(World& world, const Motion& at, double ahead, double kick, Rates& rates) {
  rates.dissipated = 0.0;
  rates.outsideWork = 0.0;
  if (world.contacts.quiet()) {
    world.forces.clear();
  } else {
    const std::vector<MovingCollider> colliders = world.controls.collidersAhead(ahead);
    ContactMoment trial{at, colliders, world.controls.materials(), kick};
    trial.time = world.time() + ahead;
    trial.awake = world.fragments.activity.awakeLanes();
    trial.awakeVersion = world.fragments.activity.version();
    const ColliderWork work = findContactForces(world.contacts, trial, world.forces);
    rates.outsideWork += work.outside / kick;
    rates.dissipated += work.dissipated / kick;
    world.work.contactPairs += world.contacts.pairCount();
  }
  rates.outsideWork += carryingWork(world, at, world.forces, 1.0);
  Motion unmoved;
  KernelStep step = kernelStep(world, at, unmoved);
  for (std::size_t k = 0; k < 3; ++k) step.nextVelocity[k] = rates.acceleration.axis(k);
  step.accelerationOnly = true;
  runKernel(world, step, world.reports);
  rates.dissipated += dissipatedBy(world, world.reports);
  world.work.bondsEvaluated += world.network.bondCount() - world.breakage.brokenBondCount();
}

void tangentsAt(const World& world, const Motion& at, double ahead, double kick,
                std::vector<Tangent>& tangents) {
  const Network& network = world.network;
  tangents.clear();
  for (BondIndex index = 0; index < network.bondCount(); ++index) {
    if (world.breakage.bondBroken(index)) continue;
    const BondClass& bond = network.bond(index);
    const MaterialNow& material = world.controls.materials()[bond.material];
    const NodeIndex a = network.bondStart(index);
    const NodeIndex b = network.bondEnds[index];
    const Vec3 apart = at.position.get(b) - at.position.get(a);
    const double length = apart.norm();
    const double stiffness = bond.stiffness * material.stiffnessScale;
    const double tension = std::max(0.0, 1.0 - world.layout.restLength(network, index) / length);
    tangents.push_back(
        {a, b, apart / length, stiffness, stiffness * tension, bond.damping * material.dampingScale, 0.0});
  }
  if (world.contacts.quiet()) return;
  const std::vector<MovingCollider> colliders = world.controls.collidersAhead(ahead);
  ContactMoment trial{at, colliders, world.controls.materials(), kick};
  trial.time = world.time() + ahead;
  addContactTangents(world.contacts, trial, world.forces, tangents);
}

}  // namespace sim
