#pragma once

#include <algorithm>
#include <vector>

#include "sim/world/world.h"

namespace sim {

/// How a fragment moves as a whole.
struct FragmentSums {
  double mass = 0.0;                                  ///< g
  double kinetic = 0.0;                               ///< erg
  Vec3 centre = Vec3::Zero();                         ///< cm
  Vec3 momentum = Vec3::Zero();                       ///< g cm/s
  Vec3 spin = Vec3::Zero();                           ///< angular velocity of the rigid motion, rad/s
  Vec3 angularMomentum = Vec3::Zero();                ///< about the centre, g cm^2/s
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the centre, g cm^2

  /// By the rigid motion, cm/s.
  Vec3 velocityAt(const Vec3& point) const { return momentum / mass + spin.cross(point - centre); }
  /// Squared root mean square speed of the rigid motion, cm^2/s^2.
  double rigidSpeedSquared() const;
  /// Squared root mean square speed of the vibration beside it, cm^2/s^2.
  double vibrationSquared() const { return std::max(0.0, 2.0 * kinetic / mass - rigidSpeedSquared()); }
};

/// By fragment. Those of fragments that sleep have no motion, and those of rigid ones their kinetic energy
/// and momentum.
std::vector<FragmentSums> sumFragments(const World& world);
/// Root mean square speed of everything, cm/s.
double meanSpeed(const std::vector<FragmentSums>& sums);

}  // namespace sim
