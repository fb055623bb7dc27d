#include "sim/skipping/bodies.h"

#include <algorithm>

namespace sim {
namespace {

/// What contacts do to a body.
struct Push {
  Vec3 force = Vec3::Zero();          ///< dyn
  Vec3 torque = Vec3::Zero();         ///< about the centre, dyn cm
  double load = 0.0;                  ///< erg, as in RigidBody::Bearing
  std::vector<std::uint32_t> places;  ///< in nodes(), of those pushed

  /// For another body.
  void clear() {
    force = torque = Vec3::Zero();
    load = 0.0;
    places.clear();
  }
};

void findPush(const RigidBody& body, const ContactForces& forces, Push& push) {
  push.clear();
  for (const std::uint32_t place : body.touched()) {
    const NodeIndex node = body.nodes()[place];
    if (forces.touched[node / kBlockNodes] == 0) continue;
    const Vec3 force = forces.total.get(node);
    if (force.isZero(0.0)) continue;
    const Vec3 arm = body.arm(place);
    push.force += force;
    push.torque += arm.cross(force);
    push.load += force.norm() * arm.norm();
    push.places.push_back(place);
  }
}

/// As in the kernel: work against lossy forces is by the mean of the velocities before and after.
double takeForces(const RigidBody& body, const Push& push, double kick, const RigidBody::Rates& before,
                  const RigidBody::Rates& after, ContactForces& forces) {
  double dissipated = 0.0;
  for (const std::uint32_t place : push.places) {
    const NodeIndex node = body.nodes()[place];
    const Vec3 arm = body.arm(place);
    dissipated -= 0.5 * kick * forces.lossy.get(node).dot(before.at(arm) + after.at(arm));
    forces.total.set(node, Vec3::Zero());
    forces.lossy.set(node, Vec3::Zero());
  }
  return dissipated;
}

}  // namespace

double moveBodies(World& world, double kick, double drift, bool byOldVelocity) {
  const Vec3& gravity = world.controls.gravity();
  double dissipated = 0.0;
  Push push;
  for (RigidBody& body : world.fragments.bodies) {
    const Vec3 old = body.velocity();
    findPush(body, world.forces, push);
    if (!body.bears(push.load, kick, gravity.norm())) world.stopped.push_back(body.fragment());
    if (push.places.empty()) {
      body.kick(kick * gravity);
    } else {
      const RigidBody::Rates before = body.rates();
      body.kick(kick * (gravity + push.force / body.mass()), kick * push.torque);
      dissipated += takeForces(body, push, kick, before, body.rates(), world.forces);
    }
    body.drift(drift, byOldVelocity ? old : body.velocity());
  }
  return dissipated;
}

std::vector<RigidBody::Rates> ratesAfter(const World& world, double kick, ContactForces& forces,
                                         double& dissipated) {
  std::vector<RigidBody::Rates> rates;
  rates.reserve(world.fragments.bodies.size());
  Push push;
  for (const RigidBody& body : world.fragments.bodies) {
    findPush(body, forces, push);
    rates.push_back(
        body.ratesAfter(kick * (world.controls.gravity() + push.force / body.mass()), kick * push.torque));
    dissipated += takeForces(body, push, kick, body.rates(), rates.back(), forces);
  }
  return rates;
}

void placeVelocities(const World& world, NodeVectors& velocities, std::span<const RigidBody::Rates> rates) {
  for (std::size_t b = 0; b < rates.size(); ++b)
    world.fragments.bodies[b].placeVelocities(velocities, rates[b]);
}

bool anyTouched(const World& world) {
  return std::ranges::any_of(world.fragments.bodies,
                             [](const RigidBody& body) { return !body.touched().empty(); });
}

void placeTouched(World& world) {
  for (const RigidBody& body : world.fragments.bodies) body.placeTouched(world.now);
}

void placeBodies(World& world) {
  for (const RigidBody& body : world.fragments.bodies) body.place(world.now.position);
}

double fastestBody(const World& world) {
  double fastest = 0.0;
  for (const RigidBody& body : world.fragments.bodies) fastest = std::max(fastest, body.fastest());
  return fastest;
}

}  // namespace sim
