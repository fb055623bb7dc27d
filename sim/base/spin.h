#pragma once

#include <Eigen/Core>

#include "sim/base/types.h"

namespace sim {

/// The angular velocity (rad/s) at which a body of this inertia (g cm^2) has this angular momentum (g
/// cm^2/s), both about one point. Where the body has no extent across an axis, it does not turn about that
/// axis.
Vec3 spinOf(const Eigen::Matrix3d& inertia, const Vec3& angularMomentum);

}  // namespace sim
