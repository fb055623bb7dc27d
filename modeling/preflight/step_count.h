#pragma once

#include "sim/dynamics/simulation.h"

namespace modeling {

/// Steps of a run.
struct StepCount {
  double all = 0.0;
  double rigid = 0.0;  ///< of them, those in which nothing deforms: they cost next to nothing
};

/// How many steps a run makes from its start to `duration` (s), as long as nothing breaks.
///
/// The step follows the stiffness that tracks give at each time, and how fast things are: no node may go far
/// in one step. Things are as fast as they fall and fly freely until they have landed. After that they are
/// taken to go on at three quarters of the speed they landed with, as soft things do; where things come to
/// rest and sleep it is fewer steps. What flies is taken as rigid where that may be (`freezesInFlight`,
/// solver.skip.rigid): its lattice allows a longer step.
StepCount expectedSteps(const sim::Simulation& simulation, const sim::Environment& environment,
                        const std::vector<sim::Track>& tracks, bool freezesInFlight, double duration);

}  // namespace modeling
