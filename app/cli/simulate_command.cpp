#include <filesystem>
#include <iostream>
#include <memory>

#include "app/cli/commands.h"
#include "app/cli/progress.h"
#include "app/cli/running.h"
#include "app/cli/scene_options.h"
#include "modeling/preflight/overlaps.h"
#include "modeling/scene/build.h"
#include "modeling/text/printable.h"
#include "sim/take/take.h"

namespace app {
namespace {

struct SimulateOptions {
  SceneOptions scene;
  std::string take;
  std::string report;
  int threads = 0;
};

ExitStatus simulate(const SimulateOptions& options) {
  const Stopwatch stopwatch;
  if (const sim::Status status = checkReportFile(options.report); !status) return complain(status.problem());
  const sim::Result<modeling::SceneFile> file = options.scene.load();
  if (!file) return complain(file.problem());
  const modeling::Scene& scene = file->scene;
  sim::Result<modeling::BuiltScene> built = [&] {
    Progress progress("building");
    progress.begin();
    return modeling::build(scene, std::filesystem::path(options.scene.scene).parent_path());
  }();
  if (!built) return complain(file->located(built.problem()));

  modeling::Conditions& conditions = built->conditions;
  conditions.settings.threads = options.threads;
  const sim::Environment& environment = conditions.environment;
  const std::vector<sim::Track>& tracks = conditions.tracks;
  auto simulation =
      sim::Simulation::create(std::move(built->network), environment, tracks, conditions.settings);
  if (!simulation) return complain(file->located(simulation.problem()));

  const auto overlaps = modeling::findOverlaps(**simulation, environment, tracks);
  for (const modeling::Overlap& overlap : overlaps) tell({{"", overlap.text(), ""}});

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
  return command;
}

}  // namespace app
