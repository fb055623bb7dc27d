#pragma once

#include <string>
#include <vector>

#include "sim/base/types.h"

namespace sim {

enum class Interpolation { step, linear, smooth };

/// What a track drives. Scales multiply the value built from the scene. What several tracks of one target
/// make together is said in driven.h.
enum class TrackTarget {
  gravityScale,      ///< scalar
  gravity,           ///< vector, cm/s^2: replaces the environment's
  stiffnessScale,    ///< scalar: bond stiffness k of one material, or of all (object == kNone)
  dampingScale,      ///< scalar: bond damping d of one material, or of all
  colliderPosition,  ///< vector, cm: the collider's origin; its velocity is the track's slope
  colliderRotation,  ///< vector, radians: rotation vector about the collider's origin
};

constexpr bool drivesCollider(TrackTarget target) {
  return target == TrackTarget::colliderPosition || target == TrackTarget::colliderRotation;
}
/// Whether it scales the bonds of one material, or of all.
constexpr bool scalesMaterial(TrackTarget target) {
  return target == TrackTarget::stiffnessScale || target == TrackTarget::dampingScale;
}
constexpr bool isVector(TrackTarget target) {
  return target == TrackTarget::gravity || drivesCollider(target);
}

/// A value that varies in time (paper, "Control of flexible models"): constant before the first and after the
/// last key. `step` holds a key's value until the next key; `smooth` eases with zero slope at both keys.
struct Track {
  struct Key {
    double time = 0.0;          ///< s, strictly increasing
    Vec3 value = Vec3::Zero();  ///< scalars use x
  };
  TrackTarget target = TrackTarget::gravityScale;
  std::uint32_t object = kNone;  ///< index of the material or collider; kNone: all
  Interpolation interpolation = Interpolation::linear;
  std::vector<Key> keys;  ///< not empty

  Vec3 valueAt(double time) const;
  /// Time derivative; zero for `step`.
  Vec3 slopeAt(double time) const;
  /// The value is the same from `time` until then at least, s; infinite after the last key.
  double constantUntil(double time) const;
};

}  // namespace sim
