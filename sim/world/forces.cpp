#include "sim/world/forces.h"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {

/// Blocks a task takes at least. A block of 16 nodes takes about a microsecond.
constexpr std::size_t kBlockGrain = 32;

/// Calls run(firstBlock, lastBlock) for all runs of blocks that deform.
template <class Run>
void forActiveBlocks(const World& world, const Run& run) {
  const std::span<const std::uint32_t> blocks = world.fragments.activity.activeBlocks();
  const auto runRange = [&](std::size_t begin, std::size_t end) {
    while (begin < end) {
      std::size_t next = begin + 1;
      while (next < end && blocks[next] == blocks[next - 1] + 1) ++next;
      run(blocks[begin], blocks[next - 1] + 1);
      begin = next;
    }
  };
  if (blocks.size() <= kBlockGrain) {
    runRange(0, blocks.size());
  } else {
    parallelRanges(blocks.size(), kBlockGrain, Sharing::even, runRange);
  }
}

}  // namespace

KernelStep kernelStep(const World& world, const Motion& from, Motion& to) {
  KernelStep step{};
  world.layout.describe(step);
  for (std::size_t k = 0; k < 3; ++k) {
    step.now.position[k] = from.position.axis(k);
    step.now.velocity[k] = from.velocity.axis(k);
    step.nextPosition[k] = to.position.size() > 0 ? to.position.axis(k) : nullptr;
    step.nextVelocity[k] = to.velocity.size() > 0 ? to.velocity.axis(k) : nullptr;
    // Empty until something touched; not read then.
    step.external[k] = world.forces.total.axis(k);
    step.externalLossy[k] = world.forces.lossy.axis(k);
    step.gravity[k] = world.controls.gravity()[static_cast<Eigen::Index>(k)];
  }
  step.inverseMass = world.inverseMasses.data();
  step.awake = world.fragments.activity.awakeLanes().data();
  step.hasExternal = world.forces.touched.data();
  step.materials = world.controls.materials().data();
  return step;
}

void runKernel(const World& world, const KernelStep& step, std::vector<BlockReport>& reports) {
  forActiveBlocks(
      world, [&](std::size_t first, std::size_t last) { world.kernel(step, first, last, reports.data()); });
}

double dissipatedBy(const World& world, const std::vector<BlockReport>& reports) {
  double sum = 0.0;
  for (const std::uint32_t block : world.fragments.activity.activeBlocks()) sum += reports[block].dissipated;
  return sum;
}

ContactMoment contactMoment(const World& world, double kick) {
  return {world.now,
          world.controls.colliders(),
          world.controls.materials(),
          kick,
          world.time(),
          0.0,
          world.fragments.activity.movedLanes(),
          world.fragments.activity.version(),
          world.controls.scalesStiffness()};
}

ColliderWork findContactForcesNow(const World& world, double kick, ContactForces& forces) {
  ContactMoment moment = contactMoment(world, kick);
  moment.wholeStep = true;
  return findContactForces(world.contacts, moment, forces);
}

Vec3 bondForce(const World& world, const Motion& at, NodeIndex node, NodeIndex neighbour) {
  const BondIndex index = world.network.findBond(node, neighbour);
  const BondClass& bond = world.network.bond(index);
  const MaterialNow& material = world.controls.materials()[bond.material];
  const Vec3 apart = at.position.get(neighbour) - at.position.get(node);
  const Vec3 along = apart.normalized();
  const double rate = (at.velocity.get(neighbour) - at.velocity.get(node)).dot(along);
  const double extension = apart.norm() - world.layout.restLength(world.network, index);
  return (bond.stiffness * material.stiffnessScale * extension +
          bond.damping * material.dampingScale * rate) *
         along;
}

double carryingWork(const World& world, const Motion& at, const ContactForces& forces, double kick) {
  double work = 0.0;
  for (const NodeIndex node : world.carried) {
    Vec3 force = Vec3::Zero();
    if (forces.touched[node / kBlockNodes] != 0) force += forces.total.get(node);
    world.layout.forEachNeighbour(
        node, [&](NodeIndex neighbour) { force += bondForce(world, at, node, neighbour); });
    work -= kick * force.dot(at.velocity.get(node));
  }
  return work;
}

double strainIn(const World& world, const Motion& motion, BondIndex bond) {
  const NodeIndex a = world.network.bondStart(bond);
  const NodeIndex b = world.network.bondEnds[bond];
  const double length = (motion.position.get(b) - motion.position.get(a)).norm();
  return length / world.layout.restLength(world.network, bond) - 1.0;
}

double fastestSpeed(const World& world) {
  double squared = 0.0;
  for (NodeIndex node = 0; node < world.network.nodeCount(); ++node)
    squared = std::max(squared, world.now.velocity.get(node).squaredNorm());
  double fastest = std::sqrt(squared);
  for (const RigidBody& body : world.fragments.bodies) fastest = std::max(fastest, body.fastest());
  return fastest;
}

}  // namespace sim
