#include "sim/world/world.h"

#include <cmath>

namespace sim {
namespace {

Motion motionOf(const Network& network) {
  Motion motion{NodeVectors(network.nodeCount(), 0), NodeVectors(network.nodeCount(), 1)};
  for (std::size_t node = 0; node < network.nodeCount(); ++node) {
    motion.position.set(node, network.positions[node]);
    motion.velocity.set(node, network.velocities[node]);
  }
  return motion;
}

AlignedVector<double> inverseMassesOf(const Network& network) {
  AlignedVector<double> inverse(NodeVectors::paddedCount(network.nodeCount()), 0.0);
  for (std::size_t node = 0; node < network.nodeCount(); ++node)
    inverse[node] = std::isfinite(network.masses[node]) ? 1.0 / network.masses[node] : 0.0;
  return inverse;
}

std::vector<NodeIndex> carriedNodes(const Network& network) {
  std::vector<NodeIndex> carried;
  for (NodeIndex node = 0; node < network.nodeCount(); ++node) {
    if (!std::isfinite(network.masses[node]) && !network.velocities[node].isZero(0.0))
      carried.push_back(node);
  }
  return carried;
}

}  // namespace

World::World(Network given, Environment environment, std::vector<Track> tracks, const Settings& chosen)
    : network(std::move(given)),
      settings(chosen),
      kernel(stepBlocksFor(KernelKind::automatic)),
      carried(carriedNodes(network)),
      now(motionOf(network)),
      inverseMasses(inverseMassesOf(network)),
      layout(network),
      breakage(network),
      components(network, layout),
      fragments(network, components),
      contacts(network, contactInForce(settings)),
      controls(network, std::move(environment), std::move(tracks)),
      ledger(network),
      next{NodeVectors(network.nodeCount(), 2), NodeVectors(network.nodeCount(), 3)},
      forces(layout.blockCount()),
      reports(layout.blockCount()) {}

void setStep(World& world, double seconds) {
  if (seconds == world.clock.step) return;
  world.clock.setStep(seconds);
  world.controls.setFlow(world.network, seconds);
}

bool latticeMoves(const World& world) {
  return world.network.bondCount() > world.breakage.brokenBondCount() +
                                         world.fragments.bondsIn(FragmentState::rigid) +
                                         world.fragments.bondsIn(FragmentState::asleep);
}

std::size_t World::memoryBytes() const {
  const std::size_t motion = 4 * now.position.memoryBytes() + 2 * forces.total.memoryBytes();
  return sizeof(*this) + network.memoryBytes() + layout.memoryBytes() + breakage.memoryBytes() +
         components.memoryBytes() + fragments.memoryBytes() + contacts.memoryBytes() + motion +
         inverseMasses.capacity() * sizeof(double) + reports.capacity() * sizeof(BlockReport) +
         forces.touched.capacity() + events.capacity() * sizeof(BreakEvent);
}

}  // namespace sim
