#include "sim/methods/runge_kutta.h"

#include <cmath>
#include <complex>

#include "sim/methods/vector_sums.h"

namespace sim {

RungeKutta::RungeKutta(std::size_t nodeCount)
    : stage_{NodeVectors(nodeCount), NodeVectors(nodeCount)},
      second_{NodeVectors(nodeCount)},
      third_{NodeVectors(nodeCount)},
      fourth_{NodeVectors(nodeCount)} {}

std::optional<OneStepScheme::Flow> RungeKutta::advance(RightHandSide& world, const Motion& from,
                                                       const Rates& start, double step, Motion& to) {
  using W = WeightedVectors;
  const double half = 0.5 * step;
  addWeighted(stage_.position, from.position, W{half, &from.velocity});
  addWeighted(stage_.velocity, from.velocity, W{half, &start.acceleration});
  world.rates(stage_, half, second_);
  addWeighted(stage_.position, from.position, W{half, &from.velocity}, W{half * half, &start.acceleration});
  addWeighted(stage_.velocity, from.velocity, W{half, &second_.acceleration});
  world.rates(stage_, half, third_);
  addWeighted(stage_.position, from.position, W{step, &from.velocity}, W{step * half, &second_.acceleration});
  addWeighted(stage_.velocity, from.velocity, W{step, &third_.acceleration});
  world.rates(stage_, step, fourth_);

  const double sixth = step / 6.0;
  const double sixthSquared = step * sixth;
  addWeighted(to.position, from.position, W{step, &from.velocity}, W{sixthSquared, &start.acceleration},
              W{sixthSquared, &second_.acceleration}, W{sixthSquared, &third_.acceleration});
  addWeighted(to.velocity, from.velocity, W{sixth, &start.acceleration},
              W{2.0 * sixth, &second_.acceleration}, W{2.0 * sixth, &third_.acceleration},
              W{sixth, &fourth_.acceleration});
  const auto mean = [&](double Rates::*rate) {
    return sixth * (start.*rate + 2.0 * second_.*rate + 2.0 * third_.*rate + fourth_.*rate);
  };
  return Flow{mean(&Rates::dissipated), mean(&Rates::outsideWork)};
}

/// k4 - k5 of the positions: the velocity of the last stage less that of the end.
void RungeKutta::estimateError(const Motion& from, const Rates&, double step, const Motion& to, const Rates&,
                               NodeVectors& error) const {
  constexpr double kShare = 0.1;
  addWeighted(error, NodeVectors(from.position.size()), WeightedVectors{kShare * step, &stage_.velocity},
              WeightedVectors{-kShare * step, &to.velocity});
}

std::size_t RungeKutta::memoryBytes() const {
  return 5 * stage_.position.memoryBytes();
}

double rungeKuttaReach(double zeta) {
  const std::complex<double> direction =
      zeta < 1.0 ? std::complex<double>(-zeta, std::sqrt(1.0 - zeta * zeta))
                 : std::complex<double>(-zeta - std::sqrt(zeta * zeta - 1.0), 0.0);
  const auto grows = [&](double reach) {
    const std::complex<double> z = reach * direction;
    return std::abs(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)))) > 1.0 + 1e-12;
  };
  // The region lies within 3 of zero, and contains all of the left half of the circle of radius 2.
  double inside = 2.0 / std::abs(direction);
  double outside = 3.0 / std::abs(direction);
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (inside + outside);
    (grows(middle) ? outside : inside) = middle;
  }
  return inside;
}

double rungeKuttaStableStep(const Spectrum& spectrum, const Stiffening& stiffening, double safety) {
  return safety * rungeKuttaReach(dampingRatio(spectrum, stiffening)) / totalFrequency(spectrum, stiffening);
}

}  // namespace sim
