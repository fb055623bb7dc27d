#pragma once

#include <memory>

#include "modeling/scene/scene.h"
#include "sim/dynamics/simulation.h"

namespace tests {

/// A soft block that soon sleeps, and a vase that breaks easily, on a floor; `driven` by tracks or not.
modeling::Scene tableScene(sim::Method method, bool driven = false);

/// Built and about to run.
std::unique_ptr<sim::Simulation> started(const modeling::Scene& scene, int threads);

}  // namespace tests
