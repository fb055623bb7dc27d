#pragma once

#include <span>
#include <vector>

#include "sim/base/result.h"
#include "sim/methods/step_length.h"
#include "sim/world/world.h"

/// All that a World is at a moment as bytes: the one place where it is saved and loaded, member by member.
namespace sim {

/// Everything that a resumed run needs beyond what a World was made of. Nodes of rigid bodies must have been
/// placed.
std::vector<std::byte> saveCheckpoint(const World& world, const StepLength& length);

/// Goes on from a checkpoint of a World that was made of the same. A Problem, and nothing changed, where the
/// bytes cannot have come from one.
Status loadCheckpoint(std::span<const std::byte> checkpoint, World& world, StepLength& length);

/// Of positions, velocities, broken bonds and time.
std::uint64_t hashOf(const World& world);

/// The bonds that are still whole, with plastic rest lengths (cm) as they have become. Bonds leave a layout
/// in any order: what remains keeps its own.
BondLayout layoutOf(const Network& network, std::span<const std::uint8_t> brokenBonds,
                    std::span<const double> restLengths);

}  // namespace sim
