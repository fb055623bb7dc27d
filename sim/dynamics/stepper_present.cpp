#include "sim/dynamics/stepper.h"
#include "sim/kernel/elastic_energy.h"

namespace sim {

double Stepper::elasticEnergyNow() const {
  Motion unused;
  const KernelStep step = kernelStep(now_, unused);
  return elasticEnergy(step, layout_.blockCount()) + fragments_.stillElasticEnergy(step);
}

double Stepper::potentialEnergy() const {
  return elasticEnergyNow() + contacts_.energy(moment());
}

LedgerRow Stepper::drawLedger(const Present& present) const {
  Energy energy;
  energy.elastic = elasticEnergyNow();
  energy.contact = contacts_.energy(moment());
  energy.dissipated = present.dissipated;
  energy.outsideWork = present.outsideWork;
  return ledger_.draw(time(), step_, now_.position, present.velocity, energy, controls_.gravity());
}

/// As in the kernel.
Vec3 Stepper::bondForce(const Motion& at, NodeIndex node, NodeIndex neighbour) const {
  const BondIndex index = network_.findBond(node, neighbour);
  const BondClass& bond = network_.bond(index);
  const MaterialNow& material = controls_.materials()[bond.material];
  const Vec3 apart = at.position.get(neighbour) - at.position.get(node);
  const Vec3 along = apart.normalized();
  const double rate = (at.velocity.get(neighbour) - at.velocity.get(node)).dot(along);
  const double extension = apart.norm() - layout_.restLength(network_, index);
  return (bond.stiffness * material.stiffnessScale * extension +
          bond.damping * material.dampingScale * rate) *
         along;
}

/// What whoever carries held nodes along does against the forces on them during a kick, erg.
double Stepper::carryingWork(const Motion& at, const Contacts::Forces& forces, double kick) const {
  double work = 0.0;
  for (const NodeIndex node : carried_) {
    Vec3 force = Vec3::Zero();
    if (forces.touched[node / kBlockNodes] != 0) force += forces.total.get(node);
    layout_.forEachNeighbour(node, [&](NodeIndex neighbour) { force += bondForce(at, node, neighbour); });
    work -= kick * force.dot(at.velocity.get(node));
  }
  return work;
}

/// s: what the velocity still lacks of the moment of the positions.
double Stepper::halfKick() const {
  return settings_.method == Method::velocityVerlet ? 0.5 * lastStep_ : 0.0;
}

/// So much of a kick more, without moving anything.
Stepper::Present Stepper::presentBy(Contacts::Forces& forces, double halfKick) const {
  if (halfKick == 0.0) {
    Present present{now_.velocity};
    Contacts::Forces none;
    none.touched.assign(layout_.blockCount(), 0);
    fragments_.placeVelocities(present.velocity, fragments_.ratesAfter(0.0, none, present.dissipated));
    return present;
  }
  Motion ahead{NodeVectors(network_.nodeCount()), NodeVectors(network_.nodeCount())};
  std::vector<BlockReport> reports(layout_.blockCount());
  Contacts::ColliderWork work;
  if (contacts_.quiet()) {
    Contacts::clear(forces);
  } else {
    work = contacts_.computeForces(moment(), forces);
  }
  KernelStep step = kernelStep(now_, ahead);
  for (std::size_t k = 0; k < 3; ++k) {
    step.external[k] = forces.total.axis(k);
    step.externalLossy[k] = forces.lossy.axis(k);
  }
  step.hasExternal = forces.touched.data();
  step.kick = halfKick;
  // Before the kernel, which must not see the forces on rigid bodies.
  double lost = 0.0;
  const std::vector<RigidBody::Rates> rates = fragments_.ratesAfter(halfKick, forces, lost);
  runKernel(step, reports);
  const double share = halfKick / kick();
  Present present{std::move(ahead.velocity), share * work.dissipated + lost,
                  share * work.outside + carryingWork(now_, forces, halfKick)};
  for (const std::uint32_t block : fragments_.activity().activeBlocks())
    present.dissipated += reports[block].dissipated;
  fragments_.placeVelocities(present.velocity, rates);
  return present;
}

Stepper::Present Stepper::present() const {
  return arena_.execute([&] {
    Contacts::Forces forces;
    forces.touched.assign(layout_.blockCount(), 0);
    return presentBy(forces, halfKick());
  });
}

/// Leapfrog steps of a linear network keep, to rounding, the energy with sum m v- . v+ / 2 for its kinetic
/// part, v- and v+ half a step h before and after: sum m |h a / 2|^2 / 2 less than with the velocity between
/// them. The true energy goes up and down with every swing by that much, which is no gain.
Stepper::Kept Stepper::keptEnergy() const {
  const bool verlet = settings_.method == Method::velocityVerlet;
  const auto plain = [](const LedgerRow& row) { return Kept{row, row.energy.mechanical()}; };
  if (!verlet && settings_.method != Method::symplecticEuler) return plain(drawLedger(present()));
  Contacts::Forces forces;
  forces.touched.assign(layout_.blockCount(), 0);
  // Symplectic Euler's velocity is always half a step behind; Verlet's never at its start.
  const bool together = verlet && lastStep_ == 0.0;
  const Present kicked = presentBy(forces, verlet && !together ? halfKick() : 0.5 * step_);
  Kept kept = plain(drawLedger(together ? present() : kicked));
  for (NodeIndex node = 0; node < network_.nodeCount(); ++node) {
    if (!fragments_.activity().nodeDeforms(node) || inverseMasses_[node] == 0.0) continue;
    const Vec3 kick = kicked.velocity.get(node) - now_.velocity.get(node);
    kept.energy -= 0.5 * kick.squaredNorm() / inverseMasses_[node];
  }
  return kept;
}

/// Brings velocities to the moment of the positions. When forces leap, the half kicks before and after the
/// leap must be different ones: together they would throw stiffened bonds by up to (old step / new step)
/// times their due.
void Stepper::finishKick() {
  if (settings_.method != Method::velocityVerlet || lastStep_ == 0.0) return;
  Present present = presentBy(forces_, halfKick());
  now_.velocity = std::move(present.velocity);
  ledger_.addDissipated(present.dissipated);
  ledger_.addOutsideWork(present.outsideWork);
  lastStep_ = 0.0;
  if (reference_) reference_->forgetDisplacements();
}

/// The same for gravity alone, which needs no forces: the half kick still to come is one by the gravity of
/// before.
void Stepper::shiftKick(const Vec3& gravityBefore) {
  if (settings_.method != Method::velocityVerlet) return;
  const Vec3 shift = 0.5 * lastStep_ * (gravityBefore - controls_.gravity());
  for (std::size_t node = 0; node < network_.nodeCount(); ++node) {
    if (inverseMasses_[node] > 0.0) now_.velocity.add(node, shift);
  }
  if (reference_) reference_->forgetDisplacements();
  fragments_.shiftVelocities(shift);
  fragments_.placeTouched();
}

}  // namespace sim
