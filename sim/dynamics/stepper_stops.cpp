#include "sim/base/parallel.h"
#include "sim/collider/collider_stop.h"
#include "sim/dynamics/stepper.h"

// Nodes do not get through colliders. What springs do not stop, a force does that is just large enough: it is
// found before the step, from all other forces on the node, and then is one of them, so that it is accounted
// for like friction.

namespace sim {
namespace {

constexpr std::size_t kStopGrain = 16;
/// Pieces that are rigid are looked at so many steps ahead: they deform from the next step on, which must
/// still come in time.
constexpr double kStepsAhead = 3.0;

}  // namespace

/// After the next kick, by the forces there are. As in the kernel.
Vec3 Stepper::velocityAhead(NodeIndex node) const {
  Vec3 force = Vec3::Zero();
  if (forces_.touched[node / kBlockNodes] != 0) force += forces_.total.get(node);
  if (fragments_.activity().nodeDeforms(node))
    layout_.forEachNeighbour(node, [&](NodeIndex neighbour) { force += bondForce(now_, node, neighbour); });
  return now_.velocity.get(node) + kick() * (force / network_.masses[node] + controls_.gravity());
}

/// It moves by the forces on itself: not as part of a rigid piece.
bool Stepper::movesByItself(NodeIndex node) const {
  return fragments_.activity().nodeDeforms(node) || components_.births()[components_.of(node)].nodeCount == 1;
}

/// The force that stops the node where colliders do not let it on, and what moving ones do by it.
Stepper::StopForce Stepper::stopForce(const Contacts::NearCollider& near) const {
  const bool byOldVelocity = settings_.method == Method::forwardEuler;
  const Vec3 now = now_.velocity.get(near.node);
  const Vec3 here = now_.position.get(near.node) + (byOldVelocity ? step_ : 0.0) * now;
  const double mass = network_.masses[near.node];
  const Vec3 unstopped = velocityAhead(near.node);
  Vec3 velocity = unstopped;
  StopForce stop;
  for (std::size_t c = 0; c < near.colliders.size(); ++c) {
    const MovingCollider& collider = controls_.colliders()[near.colliders[c]];
    const Vec3 stopped = stoppedVelocity(collider, here, velocity, step_, near.inside[c].nearest);
    stop.work += mass * (stopped - velocity).dot(collider.velocityAt(here));
    velocity = stopped;
  }
  // One wall of a gap may have turned it against another.
  for (const std::uint32_t c : near.colliders) {
    if (near.colliders.size() == 1) break;
    const MovingCollider& collider = controls_.colliders()[c];
    if (stoppedVelocity(collider, here, velocity, step_) == velocity) continue;
    stop.work += mass * (collider.velocityAt(here) - velocity).dot(collider.velocityAt(here));
    velocity = collider.velocityAt(here);
  }
  stop.force = mass / kick() * (velocity - unstopped);
  return stop;
}

/// Some collider would not let it go on like this.
bool Stepper::runsIntoStop(const Contacts::NearCollider& near) const {
  const Vec3 velocity = now_.velocity.get(near.node);
  return std::ranges::any_of(near.colliders, [&](std::uint32_t c) {
    return stoppedVelocity(controls_.colliders()[c], now_.position.get(near.node), velocity,
                           kStepsAhead * step_) != velocity;
  });
}

void Stepper::stopAtColliders() {
  const std::vector<Contacts::NearCollider> near =
      contacts_.nearLimits(moment(), forces_, step_, kStepsAhead);
  std::vector<StopForce> stops(near.size());
  parallelRanges(near.size(), kStopGrain, Sharing::balanced, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      if (!std::isfinite(network_.masses[near[n].node])) continue;
      if (movesByItself(near[n].node)) {
        stops[n] = stopForce(near[n]);
      } else {
        stops[n].melts = runsIntoStop(near[n]);
      }
    }
  });
  for (std::size_t n = 0; n < near.size(); ++n) {
    const NodeIndex node = near[n].node;
    if (stops[n].melts) stopped_.push_back(components_.of(node));
    if (stops[n].force.isZero(0.0)) continue;
    forces_.touched[node / kBlockNodes] = 1;
    forces_.total.add(node, stops[n].force);
    forces_.lossy.add(node, stops[n].force);
    ledger_.addOutsideWork(stops[n].work);
    ledger_.addDissipated(stops[n].work);
  }
}

/// A piece that a stop is to hold must give way where it is held.
void Stepper::meltStopped() {
  if (stopped_.empty()) return;
  fragments_.melt(stopped_, time());
  stopped_.clear();
}

/// One-step methods stop what went too deep where it did, after the step. True when something was.
bool Stepper::stopTrial(const Rates& atEnd, double length) {
  bool any = false;
  contacts_.forEachNearCollider([&](NodeIndex node, std::uint32_t c) {
    const double mass = network_.masses[node];
    if (!std::isfinite(mass)) return;
    const MovingCollider& collider = controls_.colliders()[c];
    const Vec3 from = now_.position.get(node);
    const Vec3 mean = (next_.position.get(node) - from) / length;
    const Vec3 change = stoppedVelocity(collider, from, mean, length) - mean;
    if (change.isZero(0.0)) return;
    any = true;
    const Vec3 before = next_.velocity.get(node);
    Vec3 after = before + change;
    if (after.norm() > before.norm()) after = collider.velocityAt(from);
    const double kinetic = 0.5 * mass * (after.squaredNorm() - before.squaredNorm());
    const double potential = -length * mass * atEnd.acceleration.get(node).dot(change);
    const double outside = mass * (after - before).dot(collider.velocityAt(from));
    ledger_.addOutsideWork(outside);
    ledger_.addDissipated(outside - kinetic - potential);
    next_.position.add(node, length * change);
    next_.velocity.set(node, after);
  });
  return any;
}

}  // namespace sim
