#include "app/cli/running.h"

#include <cstdio>

#include "app/cli/progress.h"
#include "app/cli/report.h"
#include "modeling/text/text_file.h"

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

ExitStatus runAndReport(sim::Simulation& simulation, Recorder& recorder, const Stopwatch& stopwatch,
                        const RunningOptions& options) {
  const double start = simulation.time();
  sim::Status ran = sim::Done{};
  {
    Progress progress("simulating");
    ran = recorder.run(options.until, [&](const sim::Simulation& now) {
      const double share = (now.time() - start) / (options.until - start);
      progress.show(share, progressText(now, options.until));
    });
  }
  const std::string outcome = ran ? "done" : ran.problem().line();
  const auto report = reportOf({simulation, recorder, stopwatch, options.method, options.threads, outcome});
  if (!options.reportFile.empty()) {
    if (const sim::Status written = writeReport(report, options.reportFile); !written) {
      return complain(written.problem(), ExitStatus::failed);
    }
  }
  printSummary(report);
  return ran ? ExitStatus::done : complain(ran.problem(), ExitStatus::failed);
}

}  // namespace app
