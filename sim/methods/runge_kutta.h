#pragma once

#include "sim/methods/one_step_scheme.h"
#include "sim/methods/spectrum.h"

namespace sim {

/// The classical method of Runge and Kutta, fourth order, of x' = v, v' = a(x, v):
///   a1 = a(x, v)                                 at t
///   a2 = a(x + h/2 v, v + h/2 a1)                at t + h/2
///   a3 = a(x + h/2 v + h^2/4 a1, v + h/2 a2)     at t + h/2
///   a4 = a(x + h v + h^2/2 a2, v + h a3)         at t + h
///   x' = x + h v + h^2/6 (a1 + a2 + a3),  v' = v + h/6 (a1 + 2 a2 + 2 a3 + a4).
/// The rates at its end serve the next step as a1, so it costs four evaluations. With them comes an embedded
/// third-order result (Dormand and Prince 1978, RK4(3)), h/10 (k4 - k5) away.
class RungeKutta final : public OneStepScheme {
 public:
  explicit RungeKutta(std::size_t nodeCount);

  std::optional<Flow> advance(RightHandSide& world, const Motion& from, const Rates& start, double step,
                              Motion& to) override;
  void estimateError(const Motion& from, const Rates& start, double step, const Motion& to, const Rates& end,
                     NodeVectors& error) const override;
  std::size_t memoryBytes() const override;

 private:
  Motion stage_;
  Rates second_, third_, fourth_;
};

/// How far from zero the stability region of this method reaches along the eigenvalues of a damped swing,
/// lambda = omega (-zeta +- sqrt(zeta^2 - 1)): the longest stable step times omega.
double rungeKuttaReach(double zeta);

/// s, see stableStep()
double rungeKuttaStableStep(const Spectrum& spectrum, const Stiffening& stiffening, double safety);

}  // namespace sim
