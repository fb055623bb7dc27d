#include "sim/world/account.h"

#include "sim/kernel/elastic_energy.h"
#include "sim/world/forces.h"

namespace sim {
namespace {

double energyOfContacts(const World& world) {
  // How long forces act has no part in the energy.
  return contactEnergy(world.contacts, contactMoment(world, 0.0));
}

/// That of what does not deform, which is not summed anew before a state changes.
double stillElasticEnergy(const World& world, KernelStep step) {
  if (!world.fragments.stillElastic) {
    step.awake = world.fragments.activity.stillLanes().data();
    world.fragments.stillElastic = elasticEnergy(step, world.layout.blockCount());
  }
  return *world.fragments.stillElastic;
}

}  // namespace

double elasticEnergy(const World& world) {
  Motion unused;
  const KernelStep step = kernelStep(world, world.now, unused);
  return elasticEnergy(step, world.layout.blockCount()) + stillElasticEnergy(world, step);
}

double potentialEnergy(const World& world) {
  return elasticEnergy(world) + energyOfContacts(world);
}

LedgerRow drawAccount(const World& world, const Present& present) {
  Energy energy;
  energy.elastic = elasticEnergy(world);
  energy.contact = energyOfContacts(world);
  energy.dissipated = present.dissipated;
  energy.outsideWork = present.outsideWork;
  return world.ledger.draw(world.time(), world.clock.step, world.now.position, present.velocity, energy,
                           world.controls.gravity());
}

}  // namespace sim
