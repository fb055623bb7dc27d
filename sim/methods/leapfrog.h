#pragma once

#include "sim/methods/integrator.h"
#include "sim/methods/rates.h"
#include "sim/methods/spectrum.h"

namespace sim {

/// The methods of the leapfrog family. They are one recurrence, v' = v + kick a(x, v), x' = x + drift w
/// (bond_kernel.h):
/// - velocity Verlet as leapfrog: v is half a step behind x, kick is half the last step plus half the next
/// (at the start
///   only the latter), w = v'. The velocity at the time of x is v + half the last step times a, computed only
///   where it is shown. It is the same trajectory as kick-drift-kick (Verlet 1967; LAMMPS fix nve), with
///   dampers and friction acting on the half-step velocity as there.
/// - symplectic Euler: kick = step, w = v'.
/// - forward Euler exactly as the paper prints it ("Dynamics"): kick = step, w = v, the old velocity.
class Leapfrog final : public Integrator {
 public:
  enum class Recurrence { forwardEuler, symplecticEuler, verlet };

  Leapfrog(Recurrence recurrence, const World& world);

  Result<double> advance(World& world, StepLength& length) override;
  double kick(const Clock& clock) const override;
  BreakingMoment breakingMoment(const World& world) const override;
  Present present(const World& world) const override;
  Kept keptEnergy(const World& world) const override;
  void finishKick(World& world) override;
  void shiftKick(World& world, const Vec3& gravityBefore) override;
  std::size_t memoryBytes() const override { return rates_.acceleration.memoryBytes(); }

 private:
  double halfKick(const Clock& clock) const;
  void findContacts(World& world) const;
  Present presentBy(const World& world, ContactForces& forces, double halfKick) const;
  void lookAtError(World& world, StepLength& length);

  Recurrence recurrence_;
  Rates rates_;  ///< scratch of lookAtError(); empty where there is no tolerance
};

/// s, see stableStep() and automaticStep()
double leapfrogStableStep(const Spectrum& spectrum, const Stiffening& stiffening, double safety);
double forwardEulerStableStep(const Spectrum& spectrum, const Stiffening& stiffening, double safety);
/// So much shorter than the stable one that no swing gains more than 0.005 of its energy on the way. Forward
/// Euler gains where a swing turns round, and its dampers take that back only where it moves: with tau = d /
/// k, by omega h^(3/2) / tau^(1/2) of what there was, worst in the stiffest swing (docs/numerics.md,
/// "Methods").
double forwardEulerCalmStep(const Spectrum& spectrum, const Stiffening& stiffening, double safety);

}  // namespace sim
