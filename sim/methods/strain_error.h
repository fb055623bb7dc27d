#pragma once

#include "sim/world/world.h"

namespace sim {

/// Root mean squares over all intact bonds.
struct StrainError {
  double error = 0.0;  ///< of strain, by errors in the positions
  double strain =
      0.0;  ///< of strain itself with its rate over omega, so that a swing is as large when it passes zero
};

/// Of the bonds of what deforms now. `error`: of the positions, cm. `omega`: of the shortest swing of bonds,
/// rad/s.
StrainError strainError(const World& world, const NodeVectors& error, double omega);

}  // namespace sim
