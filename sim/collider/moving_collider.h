#pragma once

#include "sim/collider/collider.h"

namespace sim {

/// A collider as it is at one moment, moved by its tracks.
struct MovingCollider {
  Collider shape;
  Vec3 velocity = Vec3::Zero();         ///< of its origin, cm/s
  Vec3 angularVelocity = Vec3::Zero();  ///< rad/s
  bool active = true;                   ///< else it is as if it were not there

  Vec3 velocityAt(const Vec3& point) const {
    return velocity + angularVelocity.cross(point - shape.position);
  }
};

}  // namespace sim
