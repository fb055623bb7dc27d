#pragma once

#include <array>

#include <Eigen/Geometry>

#include "sim/base/types.h"

/// From our axes and units to glTF's: metres, y up, and its front is +z: x, z, -y of ours.
namespace modeling {

inline constexpr double kMetresPerCentimetre = 0.01;

inline std::array<float, 3> upright(const sim::Vec3& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.z()), static_cast<float>(-v.y())};
}

inline std::array<float, 4> upright(const Eigen::Quaterniond& q) {
  return {static_cast<float>(q.x()), static_cast<float>(q.z()), static_cast<float>(-q.y()),
          static_cast<float>(q.w())};
}

inline std::array<float, 3> inMetres(const sim::Vec3& v) {
  return upright(kMetresPerCentimetre * v);
}

}  // namespace modeling
