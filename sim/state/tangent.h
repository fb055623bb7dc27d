#pragma once

#include "sim/base/types.h"

namespace sim {

/// A spring and damper between two nodes, or a node and the world, as the Jacobian of the forces sees it:
/// -dF/dx = stiffness n n^T + lateralStiffness (I - n n^T), and the same of the dampings for -dF/dv.
struct Tangent {
  NodeIndex a = kNone;
  NodeIndex b = kNone;            ///< kNone: the world
  Vec3 along = Vec3::Zero();      ///< n
  double stiffness = 0.0;         ///< dyn/cm
  double lateralStiffness = 0.0;  ///< dyn/cm: of tension; never negative, so that the whole is definite
  double damping = 0.0;           ///< g/s
  double lateralDamping = 0.0;    ///< g/s: of friction
};

}  // namespace sim
