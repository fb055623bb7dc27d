#include "sim/methods/leapfrog.h"

#include <algorithm>
#include <cmath>

#include "sim/contact/collider_holds.h"
#include "sim/methods/step_length.h"
#include "sim/methods/strain_error.h"
#include "sim/methods/vector_sums.h"
#include "sim/passes/collider_stops.h"
#include "sim/passes/health.h"
#include "sim/skipping/bodies.h"
#include "sim/world/forces.h"

namespace sim {
namespace {

/// The error is looked at this often: that takes forces once more.
constexpr std::uint64_t kStepsPerLook = 16;
/// Of forward Euler's swings by themselves, relative: a tenth less than a run may show.
constexpr double kMostRiseOfSwing = 0.0045;
/// Of the step at which strong dampers begin to overshoot: there the estimate of forward Euler's gain is too
/// low.
constexpr double kCalmSafety = 0.25;

}  // namespace

Leapfrog::Leapfrog(Recurrence recurrence, const World& world) : recurrence_(recurrence) {
  if (world.settings.tolerance) rates_.acceleration = NodeVectors(world.network.nodeCount());
}

double Leapfrog::kick(const Clock& clock) const {
  return recurrence_ == Recurrence::verlet ? 0.5 * (clock.last + clock.step) : clock.wanted;
}

/// s: what the velocity still lacks of the moment of the positions.
double Leapfrog::halfKick(const Clock& clock) const {
  return recurrence_ == Recurrence::verlet ? 0.5 * clock.last : 0.0;
}

/// What was overstretched at the beginning of the step breaks.
BreakingMoment Leapfrog::breakingMoment(const World& world) const {
  return {world.next, world.time() - world.clock.step};
}

void Leapfrog::findContacts(World& world) const {
  if (world.contacts.quiet() || (world.fragments.noneDeforms() && !anyTouched(world))) {
    world.forces.clear();
    return;
  }
  const double seconds = kick(world.clock);
  world.ledger.addDissipated(world.contacts.follow(world.now.position));
  const ColliderWork work = findContactForcesNow(world, seconds, world.forces);
  world.contacts.settle(world.now, world.controls.colliders(), world.time());
  world.ledger.addDissipated(followHolds(world.contacts, contactMoment(world, seconds), world.forces));
  world.ledger.addOutsideWork(work.outside);
  world.ledger.addDissipated(work.dissipated);
  world.work.contactPairs += world.contacts.pairCount();
  stopAtColliders(world, seconds, recurrence_ == Recurrence::forwardEuler);
}

Result<double> Leapfrog::advance(World& world, StepLength& length) {
  const double seconds = kick(world.clock);
  const bool byOldVelocity = recurrence_ == Recurrence::forwardEuler;
  findContacts(world);
  world.ledger.addDissipated(moveBodies(world, seconds, world.clock.step, byOldVelocity));
  const double travel = fastestBody(world) * world.clock.step;
  if (world.fragments.noneDeforms()) {
    placeTouched(world);
    return travel;
  }
  world.ledger.addOutsideWork(carryingWork(world, world.now, world.forces, seconds));
  KernelStep step = kernelStep(world, world.now, world.next);
  step.kick = seconds;
  step.drift = world.clock.step;
  step.driftByOldVelocity = byOldVelocity;
  step.flowing = true;
  runKernel(world, step, world.reports);
  const Result<double> fastest = fastestReported(world);
  if (!fastest) return fastest.problem();
  world.ledger.addDissipated(dissipatedBy(world, world.reports));
  std::swap(world.now, world.next);
  placeTouched(world);
  lookAtError(world, length);
  return std::max(travel, *fastest * world.clock.step);
}

/// The step just made from world.next to world.now. Of its error the phase is what grows: Verlet's swings are
/// quicker by (omega h)^2 / 24, so that a step is wrong by h^3 / 24 x'''.
void Leapfrog::lookAtError(World& world, StepLength& length) {
  if (!length.hasTolerance() || world.work.steps % kStepsPerLook != 0) return;
  // What is suspect of breaking is still to be looked at, by the reports of this step.
  std::vector<BlockReport> ofThisStep(world.reports.size());
  std::swap(world.reports, ofThisStep);
  const double seconds = kick(world.clock);
  const double step = world.clock.step;
  ratesAt(world, world.now, step, seconds, rates_);
  std::swap(world.reports, ofThisStep);
  NodeVectors error(world.network.nodeCount());
  const double weight = step * step / 24.0;
  addWeighted(error, error, WeightedVectors{weight, &rates_.acceleration},
              WeightedVectors{-weight / seconds, &world.now.velocity},
              WeightedVectors{weight / seconds, &world.next.velocity});
  const double scale = world.controls.largestStiffnessScale();
  const StrainError wrong = strainError(world, error, length.stiffestRate(scale));
  length.follow({wrong.error, wrong.strain, step}, kStepsPerLook * step, scale);
}

/// So much of a kick more, without moving anything.
Present Leapfrog::presentBy(const World& world, ContactForces& forces, double halfKick) const {
  if (halfKick == 0.0) return Integrator::present(world);
  Motion ahead{NodeVectors(world.network.nodeCount()), NodeVectors(world.network.nodeCount())};
  std::vector<BlockReport> reports(world.layout.blockCount());
  const double whole = kick(world.clock);
  ColliderWork work;
  if (world.contacts.quiet()) {
    forces.clear();
  } else {
    work = findContactForcesNow(world, whole, forces);
  }
  KernelStep step = kernelStep(world, world.now, ahead);
  for (std::size_t k = 0; k < 3; ++k) {
    step.external[k] = forces.total.axis(k);
    step.externalLossy[k] = forces.lossy.axis(k);
  }
  step.hasExternal = forces.touched.data();
  step.kick = halfKick;
  // Before the kernel, which must not see the forces on rigid bodies.
  double lost = 0.0;
  const std::vector<RigidBody::Rates> rates = ratesAfter(world, halfKick, forces, lost);
  runKernel(world, step, reports);
  const double share = halfKick / whole;
  Present present{std::move(ahead.velocity), share * work.dissipated + lost + dissipatedBy(world, reports),
                  share * work.outside + carryingWork(world, world.now, forces, halfKick)};
  placeVelocities(world, present.velocity, rates);
  return present;
}

Present Leapfrog::present(const World& world) const {
  ContactForces forces(world.layout.blockCount());
  return presentBy(world, forces, halfKick(world.clock));
}

/// Leapfrog steps of a linear network keep, to rounding, the energy with sum m v- . v+ / 2 for its kinetic
/// part, v- and v+ half a step h before and after: sum m |h a / 2|^2 / 2 less than with the velocity between
/// them. The true energy goes up and down with every swing by that much, which is no gain.
Integrator::Kept Leapfrog::keptEnergy(const World& world) const {
  if (recurrence_ == Recurrence::forwardEuler) return Integrator::keptEnergy(world);
  const bool verlet = recurrence_ == Recurrence::verlet;
  ContactForces forces(world.layout.blockCount());
  // Symplectic Euler's velocity is always half a step behind; Verlet's never at its start.
  const bool together = verlet && world.clock.last == 0.0;
  const double lacking = verlet && !together ? halfKick(world.clock) : 0.5 * world.clock.step;
  const Present kicked = presentBy(world, forces, lacking);
  const LedgerRow row = drawAccount(world, together ? present(world) : kicked);
  Kept kept{row, row.energy.mechanical()};
  for (NodeIndex node = 0; node < world.network.nodeCount(); ++node) {
    if (!world.fragments.activity.nodeDeforms(node) || world.inverseMasses[node] == 0.0) continue;
    const Vec3 change = kicked.velocity.get(node) - world.now.velocity.get(node);
    kept.energy -= 0.5 * change.squaredNorm() / world.inverseMasses[node];
  }
  return kept;
}

/// When forces leap, the half kicks before and after the leap must be different ones: together they would
/// throw stiffened bonds by up to (old step / new step) times their due.
void Leapfrog::finishKick(World& world) {
  if (recurrence_ != Recurrence::verlet || world.clock.last == 0.0) return;
  Present present = presentBy(world, world.forces, halfKick(world.clock));
  world.now.velocity = std::move(present.velocity);
  world.ledger.addDissipated(present.dissipated);
  world.ledger.addOutsideWork(present.outsideWork);
  world.clock.last = 0.0;
}

/// A change of gravity needs no forces.
void Leapfrog::shiftKick(World& world, const Vec3& gravityBefore) {
  if (recurrence_ != Recurrence::verlet) return;
  const Vec3 shift = 0.5 * world.clock.last * (gravityBefore - world.controls.gravity());
  for (std::size_t node = 0; node < world.network.nodeCount(); ++node) {
    if (world.inverseMasses[node] > 0.0) world.now.velocity.add(node, shift);
  }
  for (RigidBody& body : world.fragments.bodies) body.kick(shift);
  placeTouched(world);
}

double leapfrogStableStep(const Spectrum& spectrum, const Stiffening& stiffening, double safety) {
  const double zeta = dampingRatio(spectrum, stiffening);
  // sqrt(1 + zeta^2) - zeta without its cancellation where damping is strong.
  return safety * (2.0 / totalFrequency(spectrum, stiffening)) / (std::sqrt(1.0 + zeta * zeta) + zeta);
}

double forwardEulerStableStep(const Spectrum& spectrum, const Stiffening& stiffening, double safety) {
  return std::min(leapfrogStableStep(spectrum, stiffening, safety),
                  safety * shortestDamping(spectrum, stiffening));
}

double forwardEulerCalmStep(const Spectrum& spectrum, const Stiffening& stiffening, double safety) {
  const double step = forwardEulerStableStep(spectrum, stiffening, safety);
  const double calm = std::cbrt(std::pow(kMostRiseOfSwing / totalFrequency(spectrum, stiffening), 2) *
                                shortestDamping(spectrum, stiffening));
  // The bound of the dampers alone is symplectic Euler's, which has no other.
  const double slack = leapfrogStableStep(spectrum, stiffening, std::min(safety, kCalmSafety));
  return std::min({step, calm, slack});
}

}  // namespace sim
