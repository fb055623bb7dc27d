#pragma once

#include "sim/base/result.h"
#include "sim/world/world.h"

/// Whether the motion is still one: what blows up is named and stopped.
namespace sim {

/// Names the fastest node, or the first whose motion is not finite, of the step being written to world.next.
/// `what` goes on "node 7 of part 'cup' ...".
Problem blowUp(const World& world, const char* what);

/// The fastest node by the kernel's last reports, cm/s. A Problem when a speed is not finite or past all
/// sense.
Result<double> fastestReported(const World& world);

}  // namespace sim
