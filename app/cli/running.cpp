#include "app/cli/running.h"

#include <algorithm>
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

/// s: from then on it is known how long the rest takes, roughly.
constexpr double kJudgedAfter = 2.0;

/// Says how far the run is, within its frames too, and once if it will take very long.
class Watch {
 public:
  Watch(double start, double until) : start_(start), until_(until) {}

  void look(const sim::Simulation& now) {
    const double share = (now.time() - start_) / (until_ - start_);
    if (progress_.isDue()) progress_.show(share, progressText(now, until_));
    const double elapsed = progress_.elapsed();
    if (judged_ || elapsed < kJudgedAfter) return;
    const double whole = elapsed / std::max(share, 1e-300);
    judged_ = true;
    if (whole > kVeryLong) warn(whole);
  }

 private:
  static void warn(double seconds) {
    tell({{"",
           "at this pace the run takes " + roughTime(seconds) + "; it can be stopped and resumed at any time",
           "larger cells, a softer material or a shorter run (--until) are quicker"}});
  }

  Progress progress_{"simulating"};
  double start_, until_;  ///< s
  bool judged_ = false;
};

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
    Watch watch(start, until);
    ran = recording.run([&](const sim::Simulation& now) { watch.look(now); });
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
