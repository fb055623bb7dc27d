#pragma once

#include <vector>

#include "sim/world/world.h"

/// What breaks (docs/numerics.md, "Breaking").
namespace sim {

/// The state in which bonds that have just been found overstretched break, and when.
struct BreakingMoment {
  const Motion& motion;
  double time;  ///< s
};

/// Bonds of what deforms that are stretched past their thresholds in `motion`, ascending. Looks at the blocks
/// that the kernel's last reports (world.reports) are suspicious of.
std::vector<Breakage::Overstretched> findOverstretched(const World& world, const Motion& motion);

/// Breaks what is overstretched at that moment, the cells that this takes along, and relabels fragments. True
/// when something broke.
bool breakOverstretched(World& world, const BreakingMoment& moment);

}  // namespace sim
