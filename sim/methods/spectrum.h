#pragma once

#include "sim/network/network.h"

namespace sim {

/// What limits the step of an explicit method, of the whole network with every scale at 1 (docs/numerics.md,
/// "Methods").
struct Spectrum {
  /// omega, rad/s: within 4 % of the truth, and mostly above it.
  double highestFrequency = 0.0;
  /// 1/s: no swing is damped faster, by dampers alone.
  double highestDamping = 0.0;
  double shortestDamping = 0.0;  ///< smallest d / k of a bond, s
};

/// omega = min(bound by cells or by nodes, 1.03 times 20 power iterations). Breaking only lowers it.
Spectrum measureSpectrum(const Network& network);

/// How the present moment stiffens a network.
struct Stiffening {
  double stiffnessScale = 1.0;      ///< largest of the materials'
  double dampingScale = 1.0;        ///< largest of the materials'
  double contactRateSquared = 0.0;  ///< 1/s^2, see Stiffest
  double contactDamping = 0.0;      ///< 1/s
};

/// omega, rad/s, contacts counted in. Zero where nothing is stiff.
double totalFrequency(const Spectrum& spectrum, const Stiffening& stiffening);
/// zeta of a swing at the total frequency.
double dampingRatio(const Spectrum& spectrum, const Stiffening& stiffening);
/// d / k of the weakest damper, s.
double shortestDamping(const Spectrum& spectrum, const Stiffening& stiffening);

}  // namespace sim
