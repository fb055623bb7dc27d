#pragma once

#include <functional>
#include <string>
#include <vector>

#include "modeling/preflight/overlaps.h"
#include "modeling/scene/build.h"
#include "sim/dynamics/simulation.h"

namespace modeling {

/// A bond that is stretched past its threshold before anything has moved.
struct BrokenAtRest {
  sim::BondIndex bond = sim::kNone;
  std::string part;        ///< of its first node
  double strain = 0.0;     ///< relative stretch
  double threshold = 0.0;  ///< at which it breaks
};

struct PoorCell {
  sim::CellIndex cell = sim::kNone;  ///< of the network
  std::string part;                  ///< of its first node
  double scaledJacobian = 0.0;       ///< 1: a cube
  double aspect = 0.0;               ///< longest over shortest edge
};

/// What is known of a run before it begins. Times and the size of the take are estimated by how the run
/// starts, as if from the first landing on all deformed to the end: what breaks costs more, and what comes to
/// rest less.
struct Preflight {
  std::size_t nodes = 0;
  std::size_t bonds = 0;
  std::size_t cells = 0;
  std::size_t components = 0;
  std::size_t memoryBytes = 0;  ///< of the whole program as it is now, with a simulation that runs
  std::size_t peakMemoryBytes =
      0;  ///< the most it has had so far: building takes more than running, for a moment

  double stableStep = 0.0;  ///< s: what the automatic step would be at the start
  double step = 0.0;        ///< s: the one the scene takes
  sim::StepLimit stableStepLimit = sim::StepLimit::none;
  double stepsPerSecond = 0.0;  ///< of animation
  double steps = 0.0;           ///< of the whole scene
  double frames = 0.0;

  double wallSecondsPerSecond = 0.0;  ///< s on this machine for a second of animation
  double wallSeconds = 0.0;           ///< s on this machine for the whole scene
  double takeBytes = 0.0;             ///< at most about

  std::size_t brokenAtRestCount = 0;
  std::vector<BrokenAtRest> brokenAtRest;  ///< the most overstretched first, at most kMostListed
  std::vector<PoorCell> worstCells;        ///< the worst first, at most kMostListed
  std::vector<Overlap> overlaps;           ///< all that begin inside each other

  static constexpr std::size_t kMostListed = 100;
};

/// Makes a few steps and measures them, which takes about 0.4 s beside setting up. A Problem where nothing
/// can be simulated, or when `keepGoing`, asked now and then, says no.
sim::Result<Preflight> preflight(const Scene& scene, const BuiltScene& built, int threads = 0,
                                 const std::function<bool()>& keepGoing = {});

}  // namespace modeling
