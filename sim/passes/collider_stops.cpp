#include "sim/passes/collider_stops.h"

#include <algorithm>
#include <cmath>

#include "sim/base/parallel.h"
#include "sim/collider/collider_stop.h"
#include "sim/skipping/transitions.h"
#include "sim/world/forces.h"

namespace sim {
namespace {

constexpr std::size_t kStopGrain = 16;
/// Pieces that are rigid are looked at so many steps ahead: they deform from the next step on, which must
/// still come in time.
constexpr double kStepsAhead = 3.0;

/// What stops a node.
struct Stop {
  Vec3 force = Vec3::Zero();  ///< dyn
  double work = 0.0;          ///< erg, of moving colliders
  bool melts = false;         ///< instead, the rigid piece is to deform
};

/// After the next kick, by the forces there are, cm/s. As in the kernel.
Vec3 velocityAhead(const World& world, NodeIndex node, double kick) {
  Vec3 force = Vec3::Zero();
  if (world.forces.touched[node / kBlockNodes] != 0) force += world.forces.total.get(node);
  if (world.fragments.activity.nodeDeforms(node)) {
    world.layout.forEachNeighbour(
        node, [&](NodeIndex neighbour) { force += bondForce(world, world.now, node, neighbour); });
  }
  return world.now.velocity.get(node) +
         kick * (force / world.network.masses[node] + world.controls.gravity());
}

/// It moves by the forces on itself: not as part of a rigid piece.
bool movesByItself(const World& world, NodeIndex node) {
  return world.fragments.activity.nodeDeforms(node) ||
         world.components.births()[world.components.of(node)].nodeCount == 1;
}

/// A collider that the node began in and is not pushed out of.
bool isLetBe(const World& world, NodeIndex node, std::uint32_t collider) {
  const StartDepths& starts = world.contacts.starts();
  if (starts.empty()) return false;
  const Intrusion inside =
      intrusion(world.controls.colliders()[collider].shape, world.now.position.get(node));
  return inside.depth > 0.0 && starts.letsBe(node, collider, inside.normal, world.time());
}

/// The force that stops the node where colliders do not let it on, and what moving ones do by it.
Stop stopOf(const World& world, const NearCollider& near, double kick, bool byOldVelocity) {
  const double step = world.clock.step;
  const Vec3 now = world.now.velocity.get(near.node);
  const Vec3 here = world.now.position.get(near.node) + (byOldVelocity ? step : 0.0) * now;
  const double mass = world.network.masses[near.node];
  const Vec3 unstopped = velocityAhead(world, near.node, kick);
  Vec3 velocity = unstopped;
  Stop stop;
  for (std::size_t c = 0; c < near.colliders.size(); ++c) {
    if (isLetBe(world, near.node, near.colliders[c])) continue;
    const MovingCollider& collider = world.controls.colliders()[near.colliders[c]];
    const Vec3 stopped = stoppedVelocity(collider, here, velocity, step, near.inside[c].nearest);
    stop.work += mass * (stopped - velocity).dot(collider.velocityAt(here));
    velocity = stopped;
  }
  // One wall of a gap may have turned it against another.
  for (const std::uint32_t c : near.colliders) {
    if (near.colliders.size() == 1) break;
    if (isLetBe(world, near.node, c)) continue;
    const MovingCollider& collider = world.controls.colliders()[c];
    if (stoppedVelocity(collider, here, velocity, step) == velocity) continue;
    stop.work += mass * (collider.velocityAt(here) - velocity).dot(collider.velocityAt(here));
    velocity = collider.velocityAt(here);
  }
  stop.force = mass / kick * (velocity - unstopped);
  return stop;
}

/// Some collider would not let the node go on like this.
bool runsIntoStop(const World& world, const NearCollider& near) {
  const Vec3 velocity = world.now.velocity.get(near.node);
  return std::ranges::any_of(near.colliders, [&](std::uint32_t c) {
    if (isLetBe(world, near.node, c)) return false;
    return stoppedVelocity(world.controls.colliders()[c], world.now.position.get(near.node), velocity,
                           kStepsAhead * world.clock.step) != velocity;
  });
}

/// Moves a node of world.next back to where the collider lets it be.
void setBack(World& world, NodeIndex node, const MovingCollider& collider, const Vec3& change,
             const Vec3& acceleration, double length) {
  const double mass = world.network.masses[node];
  const Vec3 from = world.now.position.get(node);
  const Vec3 before = world.next.velocity.get(node);
  Vec3 after = before + change;
  if (after.norm() > before.norm()) after = collider.velocityAt(from);
  const double kinetic = 0.5 * mass * (after.squaredNorm() - before.squaredNorm());
  const double potential = -length * mass * acceleration.dot(change);
  const double outside = mass * (after - before).dot(collider.velocityAt(from));
  world.ledger.addOutsideWork(outside);
  world.ledger.addDissipated(outside - kinetic - potential);
  world.next.position.add(node, length * change);
  world.next.velocity.set(node, after);
}

}  // namespace

void stopAtColliders(World& world, double kick, bool byOldVelocity) {
  const std::vector<NearCollider> near = nodesNearLimits(world.contacts, contactMoment(world, kick),
                                                         world.forces, world.clock.step, kStepsAhead);
  std::vector<Stop> stops(near.size());
  parallelRanges(near.size(), kStopGrain, Sharing::balanced, [&](std::size_t begin, std::size_t end) {
    for (std::size_t n = begin; n < end; ++n) {
      if (!std::isfinite(world.network.masses[near[n].node])) continue;
      if (movesByItself(world, near[n].node)) {
        stops[n] = stopOf(world, near[n], kick, byOldVelocity);
      } else {
        stops[n].melts = runsIntoStop(world, near[n]);
      }
    }
  });
  for (std::size_t n = 0; n < near.size(); ++n) {
    const NodeIndex node = near[n].node;
    if (stops[n].melts) world.stopped.push_back(world.components.of(node));
    if (stops[n].force.isZero(0.0)) continue;
    world.forces.touched[node / kBlockNodes] = 1;
    world.forces.total.add(node, stops[n].force);
    world.forces.lossy.add(node, stops[n].force);
    world.ledger.addOutsideWork(stops[n].work);
    world.ledger.addDissipated(stops[n].work);
  }
}

void meltStopped(World& world) {
  if (world.stopped.empty()) return;
  meltFragments(world, world.stopped, world.time());
  world.stopped.clear();
}

bool stopAfterStep(World& world, const NodeVectors& accelerations, double length) {
  bool any = false;
  world.contacts.forEachNearCollider([&](NodeIndex node, std::uint32_t c) {
    if (!std::isfinite(world.network.masses[node]) || isLetBe(world, node, c)) return;
    const MovingCollider& collider = world.controls.colliders()[c];
    const Vec3 from = world.now.position.get(node);
    const Vec3 mean = (world.next.position.get(node) - from) / length;
    const Vec3 change = stoppedVelocity(collider, from, mean, length) - mean;
    if (change.isZero(0.0)) return;
    any = true;
    setBack(world, node, collider, change, accelerations.get(node), length);
  });
  return any;
}

}  // namespace sim
