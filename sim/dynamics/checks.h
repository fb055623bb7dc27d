#pragma once

#include <optional>

#include "sim/control/track.h"
#include "sim/dynamics/stepper.h"

/// What a Simulation refuses before it begins.
namespace sim {

/// Nothing to simulate, a setting out of range, or a track that drives nothing.
std::optional<Problem> findFault(const Network& network, const Environment& environment,
                                 const std::vector<Track>& tracks, const Settings& settings);
/// No step is stable, or the fixed one is longer than any that is.
std::optional<Problem> findUnstableStep(const Stepper& stepper);
/// What a running simulation cannot take: a track that drives nothing, a collider that is gone or another
/// one.
std::optional<Problem> findFaultOfReplan(const World& world, const Environment& environment,
                                         const std::vector<Track>& tracks);
/// Equal in all that a state of one needs to be one of the other.
bool sameNetwork(const Network& left, const Network& right);

}  // namespace sim
