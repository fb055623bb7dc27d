#include "app/cli/simulate_command.h"

#include <filesystem>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>

#include "app/cli/running.h"
#include "app/cli/scene_options.h"
#include "modeling/scene/build.h"
#include "modeling/text/text_file.h"
#include "sim/take/take.h"

namespace app {
namespace {

struct SimulateOptions {
  SceneOptions scene;
  std::string take;
  std::string report;
  int threads = 0;
};

/// The scene as it was run stands at the head of the take, complete in itself.
sim::TakeHeader headerOf(const modeling::Scene& scene) {
  sim::TakeHeader header;
  header.scene = modeling::writeScene(modeling::withoutPresets(scene));
  header.sceneHash = modeling::textHash(header.scene);
  header.framesPerSecond = scene.output.fps;
  header.seed = scene.solver.seed;
  return header;
}

ExitStatus simulate(const SimulateOptions& options) {
  const Stopwatch stopwatch;
  if (const sim::Status status = checkReportFile(options.report); !status) return complain(status.problem());
  const sim::Result<modeling::SceneFile> file = options.scene.load();
  if (!file) return complain(file.problem());
  const modeling::Scene& scene = file->scene;
  sim::Result<modeling::BuiltScene> built =
      modeling::build(scene, std::filesystem::path(options.scene.scene).parent_path());
  if (!built) return complain(file->located(built.problem()));

  modeling::Conditions& conditions = built->conditions;
  conditions.settings.threads = options.threads;
  auto simulation = sim::Simulation::create(std::move(built->network), std::move(conditions.environment),
                                            std::move(conditions.tracks), conditions.settings);
  if (!simulation) return complain(file->located(simulation.problem()));

  // Last, because it replaces what was recorded before: by now the run is sure to begin.
  std::unique_ptr<sim::TakeWriter> take;
  if (!options.take.empty()) {
    auto created = sim::TakeWriter::create(options.take, headerOf(built->scene), (*simulation)->network());
    if (!created) return complain(created.problem());
    take = std::move(created).value();
  }
  for (const std::string& warning : built->warnings) std::cout << "note          " << warning << '\n';
  Recorder recorder(**simulation, take.get(), scene.output.fps);
  if (const sim::Status begun = recorder.begin(); !begun)
    return complain(begun.problem(), ExitStatus::failed);
  return runAndReport(**simulation, recorder, stopwatch,
                      {scene.output.duration, scene.solver.method, options.threads, options.report});
}

}  // namespace

void addSimulateCommand(CLI::App& program, ExitStatus& status) {
  CLI::App* command = program.add_subcommand("simulate", "Build a scene, run it, record a take and a report");
  const auto options = std::make_shared<SimulateOptions>();
  options->scene.addTo(*command);
  command->add_option("--take", options->take, "File to record to");
  command->add_option("--report", options->report, "File for the report (JSON)");
  command->add_option("--threads", options->threads, "0: all there are")->check(CLI::Range(0, kMostThreads));
  command->callback([options, &status] { status = simulate(*options); });
}

}  // namespace app
