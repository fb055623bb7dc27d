#pragma once

#include <cstdint>

namespace sim {

/// What was done and what was spared, counted since the start.
struct Work {
  std::uint64_t steps = 0;
  std::uint64_t bondsEvaluated = 0;    ///< each physical bond once a step
  std::uint64_t bondsSkipped = 0;      ///< broken, zero or resting ones that cost nothing
  std::uint64_t contactPairs = 0;      ///< pairs of the neighbour lists looked at
  std::uint64_t neighbourLists = 0;    ///< built
  std::uint64_t contactSearches = 0;   ///< of these, the ones for which nodes were compared with each other
  std::uint64_t labelings = 0;         ///< fragments relabelled after breaks
  std::uint64_t bondsRigid = 0;        ///< of the skipped ones: in fragments that flew rigidly
  std::uint64_t bondsAsleep = 0;       ///< of the skipped ones: in fragments that slept
  std::uint64_t stepsRigid = 0;        ///< in which nothing deformed
  std::uint64_t bondsUntested = 0;     ///< that cannot break, once a step
  std::uint64_t bondsUndamped = 0;     ///< that have no damper, once a step
  std::uint64_t labelingsSkipped = 0;  ///< steps after which fragments could not have changed
  std::uint64_t ledgersSkipped = 0;    ///< steps after which energy was not accounted for
};

}  // namespace sim
