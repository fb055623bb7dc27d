#pragma once

#include <string>

#include "app/cli/command.h"
#include "app/cli/stopwatch.h"
#include "modeling/run/recording.h"
#include "sim/state/settings.h"

/// What simulate and resume have in common.
namespace app {

struct RunningOptions {
  sim::Method method = sim::Method::velocityVerlet;
  int threads = 0;
  std::string reportFile;  ///< "": none
};

/// Whether a report can be written there, asked before a long run rather than after it. "" is no report.
sim::Status checkReportFile(const std::string& file);

/// Runs to the end with progress, writes the report, prints the summary. The answer is failed when the
/// simulation blew up or the disk filled; take and report then hold everything up to there.
ExitStatus runAndReport(const sim::Simulation& simulation, modeling::Recording& recording,
                        const Stopwatch& stopwatch, const RunningOptions& options);

}  // namespace app
