#include "sim/skipping/fragment_sums.h"

#include <cmath>

#include "sim/base/spin.h"

namespace sim {

double FragmentSums::rigidSpeedSquared() const {
  return (momentum.squaredNorm() / mass + spin.dot(angularMomentum)) / mass;
}

std::vector<FragmentSums> sumFragments(const World& world) {
  const Network& network = world.network;
  std::vector<FragmentSums> sums(world.fragments.records.size());
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    const double mass = network.masses[node];
    if (!std::isfinite(mass)) continue;
    const Vec3 velocity = world.now.velocity.get(node);
    FragmentSums& sum = sums[world.components.of(node)];
    sum.mass += mass;
    sum.centre += mass * world.now.position.get(node);
    sum.momentum += mass * velocity;
    sum.kinetic += 0.5 * mass * velocity.squaredNorm();
  }
  for (FragmentSums& sum : sums) {
    if (sum.mass > 0.0) sum.centre /= sum.mass;
  }
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    const double mass = network.masses[node];
    if (!std::isfinite(mass) || !world.fragments.activity.deforms(world.components.of(node))) continue;
    FragmentSums& sum = sums[world.components.of(node)];
    const Vec3 arm = world.now.position.get(node) - sum.centre;
    sum.angularMomentum += mass * arm.cross(world.now.velocity.get(node));
    sum.inertia += mass * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
  }
  for (FragmentId fragment = 0; fragment < sums.size(); ++fragment) {
    FragmentSums& sum = sums[fragment];
    // By rounding, the mean of one place is not that place.
    if (world.components.births()[fragment].nodeCount == 1) continue;
    if (sum.inertia.trace() > 0.0) sum.spin = spinOf(sum.inertia, sum.angularMomentum);
  }
  for (const RigidBody& body : world.fragments.bodies) {
    FragmentSums& sum = sums[body.fragment()];
    sum.kinetic = body.kineticEnergy();
    sum.centre = body.centre();
    sum.momentum = body.mass() * body.velocity();
    sum.spin = body.angularVelocity();
    sum.angularMomentum = body.angularMomentum();
  }
  return sums;
}

double meanSpeed(const std::vector<FragmentSums>& sums) {
  double mass = 0.0;
  double energy = 0.0;
  for (const FragmentSums& sum : sums) {
    mass += sum.mass;
    energy += sum.kinetic;
  }
  return mass > 0.0 ? std::sqrt(2.0 * energy / mass) : 0.0;
}

}  // namespace sim
