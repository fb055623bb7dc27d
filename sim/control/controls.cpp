#include "sim/control/controls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sim {
namespace {

/// Whether they push alike where they are.
bool pushAlike(const Collider& left, const Collider& right) {
  return left.shape == right.shape && left.stiffness == right.stiffness &&
         left.dampingRatio == right.dampingRatio && left.friction == right.friction;
}

bool drives(const Track& track, TrackTarget target, std::uint32_t object) {
  return track.target == target && track.object == object;
}

bool drivesCollider(const Track& track) {
  return track.target == TrackTarget::colliderPosition || track.target == TrackTarget::colliderRotation;
}

}  // namespace

Controls::Controls(const Network& network, Environment environment, std::vector<Track> tracks)
    : gravity_(environment.gravity), materials_(network.materials.size()) {
  for (std::size_t m = 0; m < materials_.size(); ++m)
    materials_[m].yieldStrain = network.materials[m].yieldStrain;
  replan(std::move(environment), std::move(tracks));
}

void Controls::replan(Environment environment, std::vector<Track> tracks) {
  environment_ = std::move(environment);
  tracks_ = std::move(tracks);
  for (std::size_t c = colliders_.size(); c < environment_.colliders.size(); ++c)
    colliders_.push_back({environment_.colliders[c], Vec3::Zero(), Vec3::Zero(), false});
  moved_.resize(colliders_.size(), 0);
  constantUntil_ = -std::numeric_limits<double>::infinity();
}

Controls::Change Controls::moveTo(double time) {
  Change change;
  moveColliders(time, change);
  const Vec3 gravity = gravityAt(time);
  change.gravity = gravity != gravity_;
  gravity_ = gravity;
  std::vector<MaterialNow> materials = materialsAt(time);
  change.stiffness = !std::equal(materials.begin(), materials.end(), materials_.begin(),
                                 [](const MaterialNow& left, const MaterialNow& right) {
                                   return left.stiffnessScale == right.stiffnessScale &&
                                          left.dampingScale == right.dampingScale;
                                 });
  materials_ = std::move(materials);
  constantUntil_ = constantFrom(time);
  return change;
}

Vec3 Controls::gravityAt(double time) const {
  Vec3 gravity = environment_.gravity;
  double scale = 1.0;
  bool given = false;
  for (const Track& track : tracks_) {
    if (track.target == TrackTarget::gravityScale) scale *= track.valueAt(time).x();
    if (track.target != TrackTarget::gravity) continue;
    if (!given || track.keys.front().time <= time) gravity = track.valueAt(time);
    given = true;
  }
  return scale * gravity;
}

std::vector<MaterialNow> Controls::materialsAt(double time) const {
  std::vector<MaterialNow> materials = materials_;
  for (MaterialNow& material : materials) material.stiffnessScale = material.dampingScale = 1.0;
  for (const Track& track : tracks_) {
    const bool stiffness = track.target == TrackTarget::stiffnessScale;
    if (!stiffness && track.target != TrackTarget::dampingScale) continue;
    double MaterialNow::*scale = stiffness ? &MaterialNow::stiffnessScale : &MaterialNow::dampingScale;
    const double value = track.valueAt(time).x();
    for (std::size_t m = 0; m < materials.size(); ++m) {
      if (track.object == kNone || track.object == m) materials[m].*scale *= value;
    }
  }
  return materials;
}

void Controls::moveColliders(double time, Change& change) {
  colliderTravel_ = 0.0;
  for (std::uint32_t c = 0; c < colliders_.size(); ++c) {
    moved_[c] = 0;
    if (!colliders_[c].active && !environment_.colliders[c].activeAt(time)) continue;
    moveCollider(c, placeOf(c, time), change);
  }
}

Controls::Place Controls::placeOf(std::uint32_t c, double time) const {
  const Collider& written = environment_.colliders[c];
  Place place{{written, Vec3::Zero(), Vec3::Zero(), written.activeAt(time)}};
  for (const Track& track : tracks_) {
    if (drives(track, TrackTarget::colliderPosition, c)) {
      place.at.shape.position = track.valueAt(time);
      place.at.velocity = track.slopeAt(time);
      place.glides = track.interpolation != Interpolation::step;
    }
    if (drives(track, TrackTarget::colliderRotation, c)) {
      const Vec3 rotation = track.valueAt(time);
      const double angle = rotation.norm();
      const Vec3 axis = angle > 0.0 ? Vec3(rotation / angle) : Vec3(Vec3::UnitZ());
      place.at.shape.rotation = Eigen::AngleAxisd(angle, axis) * written.rotation;
      // Exact where the axis stays the same between keys, which is what keys of a turn are.
      place.at.angularVelocity = track.slopeAt(time);
      place.turns = track.interpolation != Interpolation::step;
    }
  }
  return place;
}

void Controls::moveCollider(std::uint32_t c, const Place& place, Change& change) {
  MovingCollider& now = colliders_[c];
  const MovingCollider before = std::exchange(now, place.at);
  if (before.active != now.active) {
    change.colliders = true;
    moved_[c] = now.active ? 1 : 0;
    return;
  }
  const double shift = (now.shape.position - before.shape.position).norm();
  const bool turned = before.shape.rotation.coeffs() != now.shape.rotation.coeffs();
  const double turn =
      turned ? before.shape.rotation.angularDistance(now.shape.rotation) * reachOf(now.shape) : 0.0;
  const bool another = !pushAlike(before.shape, now.shape);
  change.leap |= another || (shift > 0.0 && !place.glides) || (turn > 0.0 && !place.turns);
  change.colliders |= another;
  moved_[c] = shift > 0.0 || turn > 0.0 ? 1 : 0;
  change.motion |=
      moved_[c] != 0 || now.velocity != before.velocity || now.angularVelocity != before.angularVelocity;
  colliderTravel_ = std::max(colliderTravel_, shift + turn);
}

bool Controls::anyMoved() const {
  return std::ranges::find(moved_, 1) != moved_.end();
}

double Controls::constantFrom(double time) const {
  double until = std::numeric_limits<double>::infinity();
  for (const Track& track : tracks_) {
    if (!drivesCollider(track) || colliders_[track.object].active)
      until = std::min(until, track.constantUntil(time));
  }
  for (const Collider& collider : environment_.colliders) {
    for (const double change : {collider.activeFrom, collider.activeUntil}) {
      if (time < change) until = std::min(until, change);
    }
  }
  return until;
}

std::vector<MovingCollider> Controls::collidersAhead(double ahead) const {
  std::vector<MovingCollider> moved = colliders_;
  for (MovingCollider& collider : moved) {
    collider.shape.position += ahead * collider.velocity;
    const double angle = ahead * collider.angularVelocity.norm();
    if (angle != 0.0) {
      const Eigen::AngleAxisd turn(angle, collider.angularVelocity.normalized());
      collider.shape.rotation = turn * collider.shape.rotation;
    }
  }
  return moved;
}

void Controls::setFlow(const Network& network, double step) {
  for (std::size_t m = 0; m < materials_.size(); ++m)
    materials_[m].flow = std::min(1.0, network.materials[m].flowRate * step);
}

bool Controls::scalesStiffness() const {
  return std::ranges::any_of(materials_, [](const MaterialNow& now) { return now.stiffnessScale != 1.0; });
}

double Controls::largestStiffnessScale() const {
  double largest = 0.0;
  for (const MaterialNow& material : materials_) largest = std::max(largest, material.stiffnessScale);
  return largest;
}

double Controls::largestDampingScale() const {
  double largest = 0.0;
  for (const MaterialNow& material : materials_) largest = std::max(largest, material.dampingScale);
  return largest;
}

}  // namespace sim
