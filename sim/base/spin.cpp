#include "sim/base/spin.h"

#include <Eigen/QR>

namespace sim {

Vec3 spinOf(const Eigen::Matrix3d& inertia, const Vec3& angularMomentum) {
  return inertia.completeOrthogonalDecomposition().solve(angularMomentum);
}

}  // namespace sim
