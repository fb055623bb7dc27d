#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/cli/stopwatch.h"
#include "app/results/json.h"
#include "modeling/run/recording.h"
#include "modeling/scene/scene.h"
#include "sim/dynamics/simulation.h"

namespace app {

/// Where a run's results go, beside its take.
struct ReportInput {
  const sim::Simulation& simulation;
  const modeling::Recording& recording;
  const Stopwatch& stopwatch;
  sim::Method method = sim::Method::velocityVerlet;
  int threads = 0;      ///< as asked for; 0: all there are
  std::string outcome;  ///< "done", or the line of the Problem that ended the run
};

/// What a run came to (docs/formats.md, "Report"). cgs.
Json reportOf(const ReportInput& input);

/// Replaces the file in one step.
sim::Status writeReport(const Json& report, const std::filesystem::path& file);

/// The few numbers a person looks for, on standard output.
void printSummary(const Json& report);

}  // namespace app
