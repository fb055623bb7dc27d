#include "sim/passes/breaking.h"

#include <algorithm>
#include <cmath>

#include "sim/base/parallel.h"
#include "sim/skipping/review.h"
#include "sim/world/forces.h"

namespace sim {
namespace {

/// Below this share of the squared length at which it breaks, no rounding makes a bond break.
constexpr double kSurelyWhole = 1.0 - 1e-5;
constexpr std::size_t kBlocksPerTask = 512;

/// The exact test, for the bonds that begin in one block.
void testBlock(const World& world, const Motion& motion, std::size_t block,
               std::vector<Breakage::Overstretched>& found) {
  const Network& network = world.network;
  const std::size_t end = std::min(network.nodeCount(), (block + 1) * kBlockNodes);
  for (auto node = static_cast<NodeIndex>(block * kBlockNodes); node < end; ++node) {
    // Nodes of rigid bodies are not where the bodies are until someone looks.
    if (!world.fragments.activity.nodeDeforms(node)) continue;
    for (BondIndex bond = network.firstBond[node]; bond < network.firstBond[node + 1]; ++bond) {
      if (world.breakage.bondBroken(bond)) continue;
      const double limit =
          world.layout.restLength(network, bond) * (1.0 + static_cast<double>(network.thresholds[bond]));
      const Vec3 apart = motion.position.get(network.bondEnds[bond]) - motion.position.get(node);
      if (apart.squaredNorm() < kSurelyWhole * limit * limit) continue;
      const auto strain = static_cast<float>(strainIn(world, motion, bond));
      if (strain > network.thresholds[bond]) found.push_back({bond, strain});
    }
  }
}

/// Takes a broken bond out of the lattice. Its tension energy is dropped; in compression it keeps its energy
/// and goes on repelling (docs/numerics.md, "Breaking"). With leapfrog methods the bond's last kick carried
/// velocities from half a step before to half a step behind, so what is dropped is the mean of its energies
/// before and after: either alone would leave the account wrong in first order of the step. With one-step
/// methods both are the present one.
void loseBond(World& world, const BreakEvent& event, const Motion& brokeIn) {
  const BondClass& bond = world.network.bond(event.bond);
  const double restLength = world.layout.restLength(world.network, event.bond);
  const auto extensionIn = [&](const Motion& motion) {
    return (motion.position.get(event.b) - motion.position.get(event.a)).norm() - restLength;
  };
  const double before = std::max(0.0, extensionIn(brokeIn));
  const double after = extensionIn(world.now);
  const double stiffness = bond.stiffness * world.controls.materials()[bond.material].stiffnessScale;
  if (after > 0.0) world.ledger.addReleased(0.25 * stiffness * (before * before + after * after));
  world.contacts.addBroken(event.bond, restLength);
  world.layout.remove(world.network, event.bond);
}

}  // namespace

std::vector<Breakage::Overstretched> findOverstretched(const World& world, const Motion& motion) {
  using Found = std::vector<Breakage::Overstretched>;
  const std::span<const std::uint32_t> blocks = world.fragments.activity.activeBlocks();
  return collectInOrder<Breakage::Overstretched>(blocks.size(), kBlocksPerTask,
                                                 [&](std::size_t b, Found& found) {
                                                   if (world.reports[blocks[b]].suspect)
                                                     testBlock(world, motion, blocks[b], found);
                                                 });
}

bool breakOverstretched(World& world, const BreakingMoment& moment) {
  const std::vector<Breakage::Overstretched> overstretched = findOverstretched(world, moment.motion);
  if (overstretched.empty()) {
    ++world.work.labelingsSkipped;
    return false;
  }
  const std::size_t before = world.events.size();
  const auto strainOf = [&](BondIndex bond) {
    return static_cast<float>(strainIn(world, moment.motion, bond));
  };
  world.breakage.breakBonds(overstretched, moment.time, strainOf, world.events);
  const std::span<const BreakEvent> fresh = std::span<const BreakEvent>(world.events).subspan(before);
  for (const BreakEvent& event : fresh) loseBond(world, event, moment.motion);
  if (world.components.relabel(world.layout, fresh, world.time())) {
    noteFragmentBirths(world, world.time());
    world.contacts.age().noteBirths();
  }
  world.work.labelings = world.components.relabelings();
  return true;
}

}  // namespace sim
