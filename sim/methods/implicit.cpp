#include "sim/methods/implicit.h"

#include <cmath>

#include <Eigen/IterativeLinearSolvers>

#include "sim/methods/vector_sums.h"

namespace sim {
namespace {

/// Of the velocities: what is left of the equation when it counts as solved. Ten times more would show in the
/// account of energy after a million steps; much less is lost in the rounding of stiff forces.
constexpr double kTolerance = 1e-10;
/// Newton's method takes three to six steps; if it takes so many it follows contacts that open and close.
constexpr int kMostIterations = 30;
constexpr int kMostHalvings = 4;
/// How far conjugate gradients go within one step of Newton's: what they leave the next takes up.
constexpr double kLinearTolerance = 1e-5;

/// Accuracy sets the step: so many times what an undamped explicit method could do. Then waves of some ten
/// cells and longer are still resolved, and an explicit step costs less than a tenth of an implicit one, so
/// that shorter steps would have no use.
constexpr double kImplicitStretch = 10.0;

using Solver = Eigen::ConjugateGradient<TangentMatrix::Matrix, Eigen::Lower | Eigen::Upper>;

Eigen::Index rowOf(std::size_t node) {
  return static_cast<Eigen::Index>(3 * node);
}

}  // namespace

Implicit::Implicit(bool midpoint, std::span<const double> inverseMasses, std::size_t nodeCount)
    : midpoint_(midpoint),
      inverseMasses_(inverseMasses),
      nodeCount_(nodeCount),
      trial_{NodeVectors(nodeCount), NodeVectors(nodeCount)},
      rates_{NodeVectors(nodeCount)},
      w_(rowOf(nodeCount)),
      residual_(rowOf(nodeCount)) {}

double Implicit::evaluate(RightHandSide& world, const Motion& from, double h, const Eigen::VectorXd& w) {
  for (std::size_t node = 0; node < nodeCount_; ++node) trial_.velocity.set(node, w.segment<3>(rowOf(node)));
  addWeighted(trial_.position, from.position, WeightedVectors{h, &trial_.velocity});
  world.rates(trial_, h, rates_);
  double left = 0.0;
  double scale = 0.0;
  for (std::size_t node = 0; node < nodeCount_; ++node) {
    auto residual = residual_.segment<3>(rowOf(node));
    residual.setZero();
    if (inverseMasses_[node] == 0.0) continue;
    const double mass = 1.0 / inverseMasses_[node];
    const Vec3 gained = h * rates_.acceleration.get(node);
    const Vec3 difference = trial_.velocity.get(node) - from.velocity.get(node) - gained;
    residual = mass * difference;
    left += mass * difference.squaredNorm();
    scale += mass * (from.velocity.get(node).squaredNorm() + gained.squaredNorm());
  }
  scale_ = std::sqrt(scale);
  return std::sqrt(left);
}

bool Implicit::solve(RightHandSide& world, const Motion& from, double h) {
  for (std::size_t node = 0; node < nodeCount_; ++node) w_.segment<3>(rowOf(node)) = from.velocity.get(node);
  double left = evaluate(world, from, h, w_);
  for (int iteration = 0; iteration < kMostIterations; ++iteration) {
    if (!std::isfinite(left)) return false;
    if (left <= kTolerance * scale_) return true;
    world.tangents(trial_, h, tangents_);
    Solver solver;
    solver.setTolerance(kLinearTolerance);
    solver.compute(matrix_.assemble(tangents_, inverseMasses_, nodeCount_, h));
    Eigen::VectorXd change = -solver.solve(residual_);
    const double before = left;
    left = evaluate(world, from, h, w_ + change);
    for (int halvings = 0; halvings < kMostHalvings && !(left < before); ++halvings) {
      change *= 0.5;
      left = evaluate(world, from, h, w_ + change);
    }
    w_ += change;
    if (change.isZero(0.0)) return false;
  }
  return false;
}

void Implicit::settleMomentum() {
  Vec3 missing = Vec3::Zero();
  double mass = 0.0;
  for (std::size_t node = 0; node < nodeCount_; ++node) {
    if (inverseMasses_[node] == 0.0) continue;
    missing += residual_.segment<3>(rowOf(node));
    mass += 1.0 / inverseMasses_[node];
  }
  for (std::size_t node = 0; node < nodeCount_; ++node) {
    if (inverseMasses_[node] > 0.0) trial_.velocity.add(node, -missing / mass);
  }
}

std::optional<OneStepScheme::Flow> Implicit::advance(RightHandSide& world, const Motion& from, const Rates&,
                                                     double step, Motion& to) {
  const double h = midpoint_ ? 0.5 * step : step;
  if (!solve(world, from, h)) return std::nullopt;
  settleMomentum();
  addWeighted(to.position, from.position, WeightedVectors{step, &trial_.velocity});
  if (midpoint_) {
    addWeighted(to.velocity, trial_.velocity, WeightedVectors{1.0, &trial_.velocity},
                WeightedVectors{-1.0, &from.velocity});
  } else {
    to.velocity = trial_.velocity;
  }
  return Flow{step * rates_.dissipated, step * rates_.outsideWork};
}

/// Midpoint: the next term of its own error, h^3 / 12 x'''. Euler: half of h^2 x''.
void Implicit::estimateError(const Motion& from, const Rates& start, double step, const Motion& to,
                             const Rates& end, NodeVectors& error) const {
  const NodeVectors zero(nodeCount_);
  if (midpoint_) {
    const double weight = step * step / 12.0;
    addWeighted(error, zero, WeightedVectors{weight, &end.acceleration},
                WeightedVectors{-weight, &start.acceleration});
  } else {
    addWeighted(error, zero, WeightedVectors{0.5 * step, &to.velocity},
                WeightedVectors{-0.5 * step, &from.velocity});
  }
}

std::size_t Implicit::memoryBytes() const {
  return 3 * trial_.position.memoryBytes() + 6 * nodeCount_ * sizeof(double) +
         tangents_.capacity() * sizeof(Tangent) + matrix_.memoryBytes();
}

double implicitStep(const Spectrum& spectrum, const Stiffening& stiffening, double safety) {
  return safety * kImplicitStretch * 2.0 / totalFrequency(spectrum, stiffening);
}

}  // namespace sim
