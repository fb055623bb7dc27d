#pragma once

#include <Eigen/Dense>

#include "app/bench/accuracy_scenes.h"

namespace app {

/// Equal nodes in a row along x at distance 1 cm, equal springs between them, ends free. As long as nothing
/// leaves the row its motion is linear, and each mode p swings by itself as
/// exp(-s t) (a cos(w t) + b sin(w t)), with w0 = 2 sqrt(k / m) sin(p pi / 2n), s = (d / k) w0^2 / 2 and
/// w^2 = w0^2 - s^2.
class ClosedFormChain {
 public:
  struct Constants {
    unsigned count = 2;
    double stiffness = 1000.0;   ///< dyn/cm
    double mass = 1.0;           ///< g
    double dampingRatio = 0.02;  ///< of the highest mode; below 1
  };
  /// Starts at rest, the last node pulled outwards by `pull` (cm), those before it by less, like a bell curve
  /// of this width (springs).
  ClosedFormChain(const Constants& constants, double pull, double reach);

  sim::Blueprint blueprint() const;
  std::vector<sim::Vec3> positionsAt(double time) const;
  /// s: of the slowest mode.
  double longestPeriod() const;

 private:
  double frequency(Eigen::Index mode) const;

  Constants constants_;
  double dampingTime_ = 0.0;    ///< d / k, s
  Eigen::VectorXd start_;       ///< displacements, cm
  Eigen::MatrixXd modes_;       ///< orthonormal columns
  Eigen::VectorXd amplitudes_;  ///< of the start in each mode, cm
};

}  // namespace app
