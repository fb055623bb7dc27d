#include "sim/dynamics/controls.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {
namespace {

/// Distance of the furthest point of a collider's surface from its origin, cm. A plane has none.
double reachOf(const Collider& collider) {
  switch (collider.shape) {
    case ColliderShape::floor:
      return std::numeric_limits<double>::max();
    case ColliderShape::box:
      return collider.halfSize.norm();
    case ColliderShape::sphere:
      return collider.radius;
    case ColliderShape::cylinder:
      return std::hypot(collider.radius, collider.halfHeight);
  }
  return 0.0;
}

}  // namespace

Controls::Controls(const Network& network, Environment environment, std::vector<Track> tracks)
    : environment_(std::move(environment)),
      tracks_(std::move(tracks)),
      gravity_(environment_.gravity),
      materials_(network.materials.size()) {
  for (const Collider& collider : environment_.colliders)
    colliders_.push_back({collider, Vec3::Zero(), Vec3::Zero()});
  moved_.assign(colliders_.size(), 0);
  for (std::size_t m = 0; m < materials_.size(); ++m)
    materials_[m].yieldStrain = network.materials[m].yieldStrain;
}

Controls::Change Controls::moveTo(double time) {
  if (tracks_.empty()) return {};
  Change change;
  change.leap = moveColliders(time);
  Vec3 gravity = environment_.gravity;
  double gravityScale = 1.0;
  std::vector<MaterialNow> materials = materials_;
  for (MaterialNow& material : materials) material.stiffnessScale = material.dampingScale = 1.0;
  const auto scaleMaterials = [&](const Track& track, double MaterialNow::*scale) {
    for (std::size_t m = 0; m < materials.size(); ++m) {
      if (track.object == kNone || track.object == m) materials[m].*scale *= track.valueAt(time).x();
    }
  };
  for (const Track& track : tracks_) {
    if (track.target == TrackTarget::gravity) gravity = track.valueAt(time);
    if (track.target == TrackTarget::gravityScale) gravityScale *= track.valueAt(time).x();
    if (track.target == TrackTarget::stiffnessScale) scaleMaterials(track, &MaterialNow::stiffnessScale);
    if (track.target == TrackTarget::dampingScale) scaleMaterials(track, &MaterialNow::dampingScale);
  }
  gravity *= gravityScale;
  change.gravity = gravity != gravity_;
  gravity_ = gravity;
  change.stiffness = !std::equal(materials.begin(), materials.end(), materials_.begin(),
                                 [](const MaterialNow& left, const MaterialNow& right) {
                                   return left.stiffnessScale == right.stiffnessScale &&
                                          left.dampingScale == right.dampingScale;
                                 });
  materials_ = std::move(materials);
  return change;
}

bool Controls::moveColliders(double time) {
  colliderTravel_ = 0.0;
  std::fill(moved_.begin(), moved_.end(), std::uint8_t{0});
  bool leapt = false;
  for (const Track& track : tracks_) {
    const bool shifts = track.target == TrackTarget::colliderPosition;
    const bool turns = track.target == TrackTarget::colliderRotation;
    if (!shifts && !turns) continue;
    MovingCollider& collider = colliders_[track.object];
    double travel = 0.0;
    if (shifts) {
      const Vec3 before = collider.shape.position;
      collider.shape.position = track.valueAt(time);
      collider.velocity = track.slopeAt(time);
      travel = (collider.shape.position - before).norm();
    } else {
      const Vec3 rotation = track.valueAt(time);
      const double angle = rotation.norm();
      const Vec3 axis = angle > 0.0 ? Vec3(rotation / angle) : Vec3(Vec3::UnitZ());
      const Eigen::Quaterniond before = collider.shape.rotation;
      collider.shape.rotation =
          Eigen::AngleAxisd(angle, axis) * environment_.colliders[track.object].rotation;
      // Exact where the axis stays the same between keys, which is what keys of a turn are.
      collider.angularVelocity = track.slopeAt(time);
      if (before.coeffs() != collider.shape.rotation.coeffs())
        travel = before.angularDistance(collider.shape.rotation) * reachOf(collider.shape);
    }
    if (travel > 0.0) moved_[track.object] = 1;
    leapt |= travel > 0.0 && track.interpolation == Interpolation::step;
    colliderTravel_ = std::max(colliderTravel_, travel);
  }
  return leapt;
}

double Controls::constantUntil(double time) const {
  double until = std::numeric_limits<double>::infinity();
  for (const Track& track : tracks_) until = std::min(until, track.constantUntil(time));
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
