#include "app/cli/resume_command.h"

#include <memory>
#include <optional>

#include <CLI/CLI.hpp>

#include "app/cli/running.h"
#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "sim/take/take.h"

namespace app {
namespace {

struct ResumeOptions {
  std::string take;
  std::string report;
  std::optional<double> until;
  int threads = 0;
};

/// All that is needed of a take before its tail is cut off.
struct Resumable {
  modeling::Scene scene;
  sim::TakeHeader header;
  sim::Network network;
  std::optional<std::size_t> frame;  ///< of the last checkpoint; none: the run was killed before its first
  std::vector<std::byte> checkpoint;
  std::vector<sim::BreakEvent> events;  ///< up to that frame
};

sim::Status readCheckpoint(const sim::TakeReader& take, Resumable& from) {
  const std::vector<std::size_t> frames = take.checkpointFrames();
  if (frames.empty()) return sim::Done{};
  from.frame = frames.back();
  sim::Result<std::vector<std::byte>> checkpoint = take.checkpoint(*from.frame);
  if (!checkpoint) return checkpoint.problem();
  from.checkpoint = std::move(checkpoint).value();
  for (std::size_t frame = 0; frame <= *from.frame; ++frame) {
    const sim::Result<std::vector<sim::BreakEvent>> events = take.eventsOf(frame);
    if (!events) return events.problem();
    from.events.insert(from.events.end(), events->begin(), events->end());
  }
  return sim::Done{};
}

sim::Result<Resumable> readTake(const std::string& file) {
  const auto take = sim::TakeReader::open(file);
  if (!take) return take.problem();
  Resumable from;
  from.header = (*take)->header();
  from.network = (*take)->network();
  sim::Result<modeling::SceneFile> scene = modeling::parseScene(from.header.scene, file + " (its scene)");
  if (!scene) return scene.problem();
  from.scene = std::move(scene->scene);
  if (const sim::Status status = readCheckpoint(**take, from); !status) return status.problem();
  return from;
}

ExitStatus resume(const ResumeOptions& options) {
  const Stopwatch stopwatch;
  if (const sim::Status status = checkReportFile(options.report); !status) return complain(status.problem());
  sim::Result<Resumable> from = readTake(options.take);
  if (!from) return complain(from.problem());
  modeling::Conditions conditions = modeling::conditionsOf(from->scene, from->network.materials);
  conditions.settings.threads = options.threads;
  auto simulation = sim::Simulation::create(std::move(from->network), std::move(conditions.environment),
                                            std::move(conditions.tracks), conditions.settings);
  if (!simulation) return complain(simulation.problem());
  if (from->frame) {
    if (const sim::Status status = (*simulation)->restore(from->checkpoint); !status)
      return complain(status.problem());
  }
  // Last, because it cuts off what stands behind the checkpoint.
  auto take = from->frame ? sim::TakeWriter::continueAfter(options.take, *from->frame)
                          : sim::TakeWriter::create(options.take, from->header, (*simulation)->network());
  if (!take) return complain(take.problem());
  (*take)->leaveOutUnmoved(from->scene.solver.skip.recording);

  Recorder recorder(**simulation, take->get(), from->header.framesPerSecond);
  recorder.takeOver(from->events);
  if (!from->frame) {
    if (const sim::Status begun = recorder.begin(); !begun)
      return complain(begun.problem(), ExitStatus::failed);
  }
  const double until = options.until.value_or(from->scene.output.duration);
  return runAndReport(**simulation, recorder, stopwatch,
                      {until, from->scene.solver.method, options.threads, options.report});
}

}  // namespace

void addResumeCommand(CLI::App& program, ExitStatus& status) {
  CLI::App* command = program.add_subcommand("resume", "Go on with a run that was killed, or past its end");
  const auto options = std::make_shared<ResumeOptions>();
  command->add_option("take", options->take, "What the run recorded; it is continued in place")->required();
  command->add_option("--until", options->until, "Seconds; left out: what the run was started for")
      ->check(CLI::Range(0.0, 1e9));
  command->add_option("--report", options->report, "File for the report (JSON)");
  command->add_option("--threads", options->threads, "0: all there are")->check(CLI::Range(0, kMostThreads));
  command->callback([options, &status] { status = resume(*options); });
}

}  // namespace app
