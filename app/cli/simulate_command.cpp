#include <filesystem>
#include <iostream>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/progress.h"
#include "app/cli/running.h"
#include "app/cli/scene_options.h"
#include "app/cli/waiting.h"
#include "modeling/files/output_guard.h"
#include "modeling/preflight/overlaps.h"
#include "modeling/scene/build.h"
#include "modeling/scene/scene_files.h"
#include "modeling/text/printable.h"
#include "sim/take/take.h"

namespace app {
namespace {

struct SimulateOptions {
  SceneOptions scene;
  std::string take;
  std::string report;
  int threads = 0;
  bool force = false;
};

sim::Status checkOutputs(const SimulateOptions& options, const modeling::Scene& scene) {
  modeling::OutputGuard guard(options.force);
  guard.reads(options.scene.scene);
  guard.reads(modeling::filesOf(scene, std::filesystem::path(options.scene.scene).parent_path()));
  guard.writes(options.take, modeling::kinds::take);
  guard.writes(options.report, modeling::kinds::report);
  return guard.check();
}

ExitStatus simulate(const SimulateOptions& options) {
  const Stopwatch stopwatch;
  if (const sim::Status status = checkReportFile(options.report); !status) return complain(status.problem());
  const sim::Result<modeling::SceneFile> file = options.scene.load();
  if (!file) return complain(file.problem());
  const modeling::Scene& scene = file->scene;
  if (const sim::Status safe = checkOutputs(options, scene); !safe) return complain(safe.problem());
  sim::Result<modeling::BuiltScene> built = [&] {
    Progress progress("building");
    progress.begin();
    return modeling::build(scene, std::filesystem::path(options.scene.scene).parent_path(),
                           Waiting().attendance());
  }();
  if (!built) return complain(file->located(built.problem()));
  for (const modeling::Overlap& overlap : modeling::findOverlaps(*built))
    std::cerr << "warning: " << modeling::printable(modeling::sentence(overlap)) << '\n';

  modeling::Conditions& conditions = built->conditions;
  conditions.settings.threads = options.threads;
  auto simulation = sim::Simulation::create(std::move(built->network), std::move(conditions.environment),
                                            std::move(conditions.tracks), conditions.settings);
  if (!simulation) return complain(file->located(simulation.problem()));

  // Last, because it replaces what was recorded before: by now the run is sure to begin.
  std::unique_ptr<sim::TakeWriter> take;
  if (!options.take.empty()) {
    auto created = modeling::createTake(options.take, built->scene, (*simulation)->network());
    if (!created) return complain(created.problem());
    take = std::move(created).value();
  }
  for (const std::string& warning : built->warnings)
    std::cout << "note          " << modeling::printable(warning) << '\n';
  auto recording =
      modeling::Recording::ofNewRun(**simulation, std::move(take), {scene.output.fps, scene.output.duration});
  return runAndReport(**simulation, recording, stopwatch,
                      {scene.solver.method, options.threads, options.report});
}

}  // namespace

Command simulateCommand() {
  const auto options = std::make_shared<SimulateOptions>();
  Command command{.name = "simulate",
                  .help = "Build a scene, run it, record a take and a report",
                  .options = options->scene.options(),
                  .run = [options] { return simulate(*options); }};
  command.options.push_back({"--take", &options->take, "File to record to"});
  command.options.push_back({"--report", &options->report, "File for the report (JSON)"});
  command.options.push_back(threadsOption(options->threads));
  command.options.push_back(forceOption(options->force));
  return command;
}

}  // namespace app
