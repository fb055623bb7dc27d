#include "sim/methods/integrator.h"

#include "sim/skipping/bodies.h"

namespace sim {

Present Integrator::present(const World& world) const {
  Present present{world.now.velocity};
  ContactForces none(world.layout.blockCount());
  placeVelocities(world, present.velocity, ratesAfter(world, 0.0, none, present.dissipated));
  return present;
}

Integrator::Kept Integrator::keptEnergy(const World& world) const {
  const LedgerRow row = drawAccount(world, present(world));
  return {row, row.energy.mechanical()};
}

}  // namespace sim
