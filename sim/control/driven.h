#pragma once

#include <vector>

#include "sim/collider/moving_collider.h"
#include "sim/control/track.h"

/// What several tracks together make of gravity, materials and colliders at a time. The only place where this
/// is decided: Controls steps a simulation by it, and scenes, takes and the window ask it.
namespace sim {

/// The gravity that scales multiply, cm/s^2: that of a track where one drives gravity, else the
/// environment's. Of several tracks the last one counts whose first key has been reached, or else the first.
Vec3 unscaledGravityAt(const std::vector<Track>& tracks, const Vec3& environments, double time);

/// The gravity that acts, cm/s^2.
Vec3 gravityAt(const std::vector<Track>& tracks, const Vec3& environments, double time);

/// The product of all tracks of a scale that drive this object: those of all objects, and its own. For kNone
/// the product of those that drive all objects.
double scaleAt(const std::vector<Track>& tracks, TrackTarget scale, std::uint32_t object, double time);

/// A collider where and as fast as its tracks have it.
struct DrivenCollider {
  MovingCollider at;
  bool glides = false;  ///< a track moves it without leaps
  bool turns = false;   ///< a track turns it without leaps
};
/// `collider` is as the environment has it, `index` its place there. Of several tracks of its position (or of
/// its rotation) the last one counts.
DrivenCollider colliderAt(const Collider& collider, std::uint32_t index, const std::vector<Track>& tracks,
                          double time);

/// From `time` until then, s, nothing changes that tracks drive, and no collider comes or goes; `time` itself
/// where something is changing. Tracks of a collider count while it is active.
double constantUntil(const std::vector<Track>& tracks, const std::vector<Collider>& colliders, double time);

}  // namespace sim
