#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "modeling/run/recording.h"
#include "ui/session/run.h"

namespace ui {

/// A run that is about to take its first step.
struct StartedRun {
  std::unique_ptr<sim::Simulation> simulation;
  std::unique_ptr<modeling::Recording> recording;  ///< of that simulation
  std::shared_ptr<Footage> footage;                ///< with the frames there are already
  modeling::Scene scene;                           ///< by which it runs
  std::vector<std::string> notes;                  ///< what is allowed but seldom meant
};

/// Builds the plan's scene, where that was not done before, and begins its take; or goes on from a frame of
/// another take: that take up to the frame is copied into a new one, and what was simulated since the last
/// checkpoint is simulated again. A Problem where that cannot be done, or `cancelled` answered true.
sim::Result<StartedRun> startRun(const RunPlan& plan, const std::function<bool()>& cancelled);

}  // namespace ui
