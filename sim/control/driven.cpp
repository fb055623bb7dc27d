#include "sim/control/driven.h"

#include <algorithm>
#include <limits>

namespace sim {

Vec3 unscaledGravityAt(const std::vector<Track>& tracks, const Vec3& environments, double time) {
  const Track* counts = nullptr;
  for (const Track& track : tracks) {
    if (track.target != TrackTarget::gravity) continue;
    if (counts == nullptr || track.keys.front().time <= time) counts = &track;
  }
  return counts == nullptr ? environments : counts->valueAt(time);
}

Vec3 gravityAt(const std::vector<Track>& tracks, const Vec3& environments, double time) {
  return scaleAt(tracks, TrackTarget::gravityScale, kNone, time) *
         unscaledGravityAt(tracks, environments, time);
}

double scaleAt(const std::vector<Track>& tracks, TrackTarget scale, std::uint32_t object, double time) {
  double product = 1.0;
  for (const Track& track : tracks) {
    if (track.target != scale) continue;
    if (track.object == kNone || track.object == object) product *= track.valueAt(time).x();
  }
  return product;
}

DrivenCollider colliderAt(const Collider& collider, std::uint32_t index, const std::vector<Track>& tracks,
                          double time) {
  DrivenCollider driven{{collider, Vec3::Zero(), Vec3::Zero(), collider.activeAt(time)}};
  for (const Track& track : tracks) {
    if (track.object != index) continue;
    const bool leaps = track.interpolation == Interpolation::step;
    if (track.target == TrackTarget::colliderPosition) {
      driven.at.shape.position = track.valueAt(time);
      driven.at.velocity = track.slopeAt(time);
      driven.glides = !leaps;
    }
    if (track.target == TrackTarget::colliderRotation) {
      const Vec3 rotation = track.valueAt(time);
      const double angle = rotation.norm();
      const Vec3 axis = angle > 0.0 ? Vec3(rotation / angle) : Vec3(Vec3::UnitZ());
      driven.at.shape.rotation = Eigen::AngleAxisd(angle, axis) * collider.rotation;
      // Exact where the axis stays the same between keys, which is what keys of a turn are.
      driven.at.angularVelocity = track.slopeAt(time);
      driven.turns = !leaps;
    }
  }
  return driven;
}

double constantUntil(const std::vector<Track>& tracks, const std::vector<Collider>& colliders, double time) {
  double until = std::numeric_limits<double>::infinity();
  for (const Track& track : tracks) {
    if (!drivesCollider(track.target) || colliders[track.object].activeAt(time))
      until = std::min(until, track.constantUntil(time));
  }
  for (const Collider& collider : colliders) {
    for (const double change : {collider.activeFrom, collider.activeUntil}) {
      if (time < change) until = std::min(until, change);
    }
  }
  return until;
}

}  // namespace sim
