#pragma once

#include "sim/network/network.h"
#include "sim/state/settings.h"

namespace sim {

/// What limits the step of an explicit method, of the whole network with every scale at 1 (docs/numerics.md).
struct Spectrum {
  /// omega, rad/s: within 4 % of the truth, and mostly above it.
  double highestFrequency = 0.0;
  double longestDamping = 0.0;   ///< largest d / k of a bond, s
  double shortestDamping = 0.0;  ///< smallest d / k of a bond, s
};

/// omega = min(bound by cells or by nodes, 1.03 times 20 power iterations). Breaking only lowers it.
Spectrum measureSpectrum(const Network& network);

/// How the present moment stiffens it.
struct Stiffening {
  double stiffnessScale = 1.0;      ///< largest of the materials'
  double dampingScale = 1.0;        ///< largest of the materials'
  double contactRateSquared = 0.0;  ///< 1/s^2, see Contacts::stiffest
  double contactDamping = 0.0;      ///< 1/s
};

/// dt = safety (2 / omega)(sqrt(1 + zeta^2) - zeta), contacts counted in; for forward Euler at most safety d
/// / k (zero when undamped: then no step is stable). Infinite when nothing limits the step.
double stableStep(const Spectrum& spectrum, const Stiffening& stiffening, Method method, double safety);

/// The step the program takes by itself: stableStep(), and for forward Euler so much shorter that no swing
/// gains more than 0.005 of its energy on the way. It gains where a swing turns round, and its dampers take
/// that back only where it moves: with tau = d / k, by omega h^(3/2) / tau^(1/2) of what there was, worst in
/// the stiffest swing (docs/numerics.md).
double automaticStep(const Spectrum& spectrum, const Stiffening& stiffening, Method method, double safety);

}  // namespace sim
