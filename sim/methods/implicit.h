#pragma once

#include <span>

#include "sim/methods/one_step_scheme.h"
#include "sim/methods/spectrum.h"
#include "sim/methods/tangent_matrix.h"

namespace sim {

/// Implicit Euler, and the implicit midpoint rule, which is implicit Euler over half the step and then as far
/// again in the same direction. Both look for the velocity w with
///   w = v + h a(x + h w, w),   h = dt or dt / 2,
/// by Newton's method: (M + h C + h^2 K) change = -M (w - v - h a), solved by conjugate gradients. C and K
/// are those of bonds and contacts where w is, without the part that compressed bonds have crosswise and that
/// would make the matrix indefinite: Newton then takes a few steps more.
///
/// Implicit Euler takes energy out of everything faster than the step, of first order. The midpoint rule is
/// of second order, symplectic, keeps linear and angular momentum, and takes out only what dampers do;
/// motions faster than the step swing on, slowly and wrongly.
class Implicit final : public OneStepScheme {
 public:
  /// The inverse masses must outlive this.
  Implicit(bool midpoint, std::span<const double> inverseMasses, std::size_t nodeCount);

  std::optional<Flow> advance(RightHandSide& world, const Motion& from, const Rates& start, double step,
                              Motion& to) override;
  void estimateError(const Motion& from, const Rates& start, double step, const Motion& to, const Rates& end,
                     NodeVectors& error) const override;
  std::size_t memoryBytes() const override;

 private:
  /// Sets trial_, rates_ and residual_ (g cm/s, three numbers a node) for this w; gives the size of what is
  /// left of the equation, sqrt(g) cm/s.
  double evaluate(RightHandSide& world, const Motion& from, double h, const Eigen::VectorXd& w);
  bool solve(RightHandSide& world, const Motion& from, double h);
  /// Conjugate gradients leave a little of the sum of all momenta behind, which a common shift takes up.
  void settleMomentum();

  bool midpoint_;
  std::span<const double> inverseMasses_;
  std::size_t nodeCount_;
  Motion trial_;  ///< x + h w, w
  Rates rates_;
  Eigen::VectorXd w_, residual_;
  double scale_ = 0.0;  ///< sqrt(g) cm/s: of what w is made of
  std::vector<Tangent> tangents_;
  TangentMatrix matrix_;
};

/// s: stable are steps of any length, so accuracy sets it, see automaticStep()
double implicitStep(const Spectrum& spectrum, const Stiffening& stiffening, double safety);

}  // namespace sim
