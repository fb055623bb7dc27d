#include "sim/methods/strain_error.h"

#include <algorithm>
#include <cmath>

#include "sim/base/parallel.h"

namespace sim {
namespace {

constexpr std::size_t kBlockGrain = 32;

/// Sums over bonds.
struct Squares {
  double error = 0.0;
  double strain = 0.0;
};

void addBond(const World& world, const NodeVectors& error, double omega, BondIndex bond, Squares& sum) {
  const NodeIndex a = world.network.bondStart(bond);
  const NodeIndex b = world.network.bondEnds[bond];
  const double restLength = world.layout.restLength(world.network, bond);
  const Vec3 apart = world.now.position.get(b) - world.now.position.get(a);
  const double distance = apart.norm();
  const Vec3 along = apart / (distance * restLength);
  const double strain = distance / restLength - 1.0;
  const double rate = along.dot(world.now.velocity.get(b) - world.now.velocity.get(a)) / omega;
  const double wrong = along.dot(error.get(b) - error.get(a));
  sum.error += wrong * wrong;
  sum.strain += strain * strain + rate * rate;
}

}  // namespace

StrainError strainError(const World& world, const NodeVectors& error, double omega) {
  const Network& network = world.network;
  const std::uint64_t intact = network.bondCount() - world.breakage.brokenBondCount();
  if (!(omega > 0.0) || intact == 0) return {};
  const std::span<const std::uint32_t> blocks = world.fragments.activity.activeBlocks();
  std::vector<Squares> squares(blocks.size());
  parallelRanges(blocks.size(), kBlockGrain, Sharing::even, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const NodeIndex first = blocks[i] * static_cast<NodeIndex>(kBlockNodes);
      const auto last =
          static_cast<NodeIndex>(std::min<std::size_t>(network.nodeCount(), first + kBlockNodes));
      for (NodeIndex node = first; node < last; ++node) {
        if (!world.fragments.activity.nodeDeforms(node)) continue;
        for (BondIndex bond = network.firstBond[node]; bond < network.firstBond[node + 1]; ++bond) {
          if (!world.breakage.bondBroken(bond)) addBond(world, error, omega, bond, squares[i]);
        }
      }
    }
  });
  Squares sum;
  for (const Squares& block : squares) {
    sum.error += block.error;
    sum.strain += block.strain;
  }
  const auto count = static_cast<double>(intact);
  return {std::sqrt(sum.error / count), std::sqrt(sum.strain / count)};
}

}  // namespace sim
