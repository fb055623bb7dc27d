#include "app/cli/running.h"

#include <cstdio>

#include "app/cli/progress.h"
#include "app/cli/report.h"
#include "modeling/files/output_file.h"

namespace app {
namespace {

std::string progressText(const sim::Simulation& simulation, double until) {
  char text[120];
  std::snprintf(text, sizeof text, "%.3f of %.3f s, step %.2g s, %llu bonds broken", simulation.time(), until,
                simulation.step(), static_cast<unsigned long long>(simulation.brokenBondCount()));
  return text;
}

}  // namespace

sim::Status checkReportFile(const std::string& file) {
  return file.empty() ? sim::Status(sim::Done{}) : modeling::checkReplaceable(file);
}

ExitStatus runAndReport(const sim::Simulation& simulation, modeling::Recording& recording,
                        const Stopwatch& stopwatch, const RunningOptions& options) {
  const double start = simulation.time();
  const double until = recording.plan().until;
  sim::Status ran = sim::Done{};
  {
    Progress progress("simulating");
    ran = recording.run([&](const sim::Simulation& now) {
      const double share = (now.time() - start) / (until - start);
      progress.show(share, progressText(now, until));
    });
  }
  const std::string outcome = ran ? "done" : ran.problem().line();
  const auto report = reportOf({simulation, recording, stopwatch, options.method, options.threads, outcome});
  if (!options.reportFile.empty()) {
    if (const sim::Status written = writeReport(report, options.reportFile); !written) {
      return complain(written.problem(), ExitStatus::failed);
    }
  }
  printSummary(report);
  return ran ? ExitStatus::done : complain(ran.problem(), ExitStatus::failed);
}

}  // namespace app
