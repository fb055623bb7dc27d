#include "sim/kernel/elastic_energy.h"

#include <cmath>
#include <vector>

#include "sim/base/parallel.h"

namespace sim {
namespace {

/// A slot's lanes whose neighbour stands behind them, so that each bond counts once.
double slotEnergy(const KernelStep& step, const BondSlot& slot, std::size_t block) {
  double sum = 0.0;
  const MaterialNow& material = step.materials[slot.material];
  for (unsigned lane = 0; lane < kBlockNodes; ++lane) {
    if (((static_cast<unsigned>(slot.live & step.awake[block]) >> lane) & 1U) == 0) continue;
    const std::size_t node = block * kBlockNodes + lane;
    const std::size_t other = slot.gathered
                                  ? step.gathers[static_cast<std::size_t>(slot.where) + lane]
                                  : static_cast<std::size_t>(static_cast<std::ptrdiff_t>(node) + slot.where);
    if (other < node) continue;
    double squared = 0.0;
    for (const double* axis : step.now.position)
      squared += (axis[other] - axis[node]) * (axis[other] - axis[node]);
    const double restLength =
        slot.varied ? step.lanes[slot.constants].restLength[lane] : step.constants[slot.constants].restLength;
    const double stiffness =
        slot.varied ? step.lanes[slot.constants].stiffness[lane] : step.constants[slot.constants].stiffness;
    const double extension = std::sqrt(squared) - restLength;
    sum += 0.5 * stiffness * material.stiffnessScale * extension * extension;
  }
  return sum;
}

}  // namespace

double elasticEnergy(const KernelStep& step, std::size_t blockCount) {
  std::vector<double> ofBlock(blockCount, 0.0);
  parallelRanges(blockCount, 64, Sharing::balanced, [&](std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; ++block) {
      if (step.awake[block] == 0) continue;
      const BondSlot* const first = step.slots + step.firstSlot[block];
      for (const BondSlot* slot = first; slot != first + step.slotCount[block]; ++slot)
        ofBlock[block] += slotEnergy(step, *slot, block);
    }
  });
  double sum = 0.0;
  for (const double energy : ofBlock) sum += energy;
  return sum;
}

}  // namespace sim
