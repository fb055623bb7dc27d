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
  const Vec3 gravity = gravityAt(tracks_, environment_.gravity, time);
  change.gravity = gravity != gravity_;
  gravity_ = gravity;
  std::vector<MaterialNow> materials = materialsAt(time);
  change.stiffness = !std::equal(materials.begin(), materials.end(), materials_.begin(),
                                 [](const MaterialNow& left, const MaterialNow& right) {
                                   return left.stiffnessScale == right.stiffnessScale &&
                                          left.dampingScale == right.dampingScale;
                                 });
  materials_ = std::move(materials);
  constantUntil_ = sim::constantUntil(tracks_, environment_.colliders, time);
  return change;
}

std::vector<MaterialNow> Controls::materialsAt(double time) const {
  std::vector<MaterialNow> materials = materials_;
  for (std::uint32_t m = 0; m < materials.size(); ++m) {
    materials[m].stiffnessScale = scaleAt(tracks_, TrackTarget::stiffnessScale, m, time);
    materials[m].dampingScale = scaleAt(tracks_, TrackTarget::dampingScale, m, time);
  }
  return materials;
}

void Controls::moveColliders(double time, Change& change) {
  colliderTravel_ = 0.0;
  for (std::uint32_t c = 0; c < colliders_.size(); ++c) {
    moved_[c] = 0;
    if (!colliders_[c].active && !environment_.colliders[c].activeAt(time)) continue;
    moveCollider(c, colliderAt(environment_.colliders[c], c, tracks_, time), change);
  }
}

void Controls::moveCollider(std::uint32_t c, const DrivenCollider& driven, Change& change) {
  MovingCollider& now = colliders_[c];
  const MovingCollider before = std::exchange(now, driven.at);
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
  change.leap |= another || (shift > 0.0 && !driven.glides) || (turn > 0.0 && !driven.turns);
  change.colliders |= another;
  moved_[c] = shift > 0.0 || turn > 0.0 ? 1 : 0;
  change.motion |=
      moved_[c] != 0 || now.velocity != before.velocity || now.angularVelocity != before.angularVelocity;
  colliderTravel_ = std::max(colliderTravel_, shift + turn);
}

bool Controls::anyMoved() const {
  return std::ranges::find(moved_, 1) != moved_.end();
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
