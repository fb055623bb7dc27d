#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "app/cli/commands.h"
#include "app/cli/frames.h"
#include "app/cli/progress.h"
#include "app/cli/running.h"
#include "modeling/exchange/continuation.h"
#include "modeling/files/output_guard.h"
#include "modeling/preflight/obstacle_depths.h"
#include "modeling/preflight/overlaps.h"
#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "modeling/text/printable.h"
#include "sim/take/take.h"

namespace app {
namespace {

struct ResumeOptions {
  std::string take;
  std::optional<std::uint64_t> from;  ///< frame
  std::optional<double> time;         ///< s
  std::string branch;                 ///< file for a take beside the old one
  std::vector<std::string> settings;
  std::string report;
  std::optional<double> until;
  int threads = 0;
  bool force = false;
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

sim::Result<std::vector<sim::BreakEvent>> eventsUpTo(const sim::TakeReader& take, std::size_t last) {
  std::vector<sim::BreakEvent> all;
  for (std::size_t frame = 0; frame <= last; ++frame) {
    const sim::Result<std::vector<sim::BreakEvent>> events = take.eventsOf(frame);
    if (!events) return events;
    all.insert(all.end(), events->begin(), events->end());
  }
  return all;
}

sim::Status readCheckpoint(const sim::TakeReader& take, Resumable& from) {
  const std::vector<std::size_t> frames = take.checkpointFrames();
  if (frames.empty()) return sim::Done{};
  from.frame = frames.back();
  sim::Result<std::vector<std::byte>> checkpoint = take.checkpoint(*from.frame);
  if (!checkpoint) return checkpoint.problem();
  from.checkpoint = std::move(checkpoint).value();
  sim::Result<std::string> scene = take.sceneOf(*from.frame);
  if (!scene) return scene.problem();
  from.header.scene = std::move(scene).value();
  sim::Result<std::vector<sim::BreakEvent>> events = eventsUpTo(take, *from.frame);
  if (!events) return events.problem();
  from.events = std::move(events).value();
  return sim::Done{};
}

sim::Result<Resumable> readTake(const std::string& file) {
  const auto take = sim::TakeReader::open(file);
  if (!take) return take.problem();
  Resumable from;
  from.header = (*take)->header();
  from.network = (*take)->network();
  if (const sim::Status status = readCheckpoint(**take, from); !status) return status.problem();
  sim::Result<modeling::SceneFile> scene = modeling::parseScene(from.header.scene, file + " (its scene)");
  if (!scene) return scene.problem();
  from.scene = std::move(scene->scene);
  return from;
}

sim::Result<std::size_t> frameOf(const ResumeOptions& options, const sim::TakeReader& take) {
  if (const sim::Status some = needFrames(take, options.take); !some) return some.problem();
  const std::size_t frame = options.from ? *options.from : frameNearest(*options.time, take);
  if (frame < take.frameCount()) return frame;
  return sim::Problem{"--from", "the take does not have a frame " + std::to_string(frame),
                      "the last one is " + std::to_string(take.frameCount() - 1)};
}

/// The take that is gone on from is read, and written too where there is no other.
sim::Status checkOutputs(const ResumeOptions& options) {
  modeling::OutputGuard guard(options.force);
  guard.reads(options.take);
  guard.writes(options.branch, modeling::kinds::take);
  guard.writes(options.report, modeling::kinds::report);
  if (const sim::Status safe = guard.check(); !safe) return safe;
  return checkReportFile(options.report);
}

sim::Status checkBranch(const ResumeOptions& options) {
  if (options.branch.empty())
    return sim::Problem{"--take", "a run that goes on from a frame needs a take of its own",
                        "name a file to record to"};
  std::error_code error;
  if (std::filesystem::equivalent(options.branch, options.take, error))
    return sim::Problem{"--take", "this is the take that is gone on from", "name another file"};
  return checkOutputs(options);
}

/// The take's scene with the settings laid over it; nothing without any.
sim::Result<std::optional<modeling::Scene>> changedScene(const ResumeOptions& options,
                                                         const sim::TakeReader& take, std::size_t frame) {
  if (options.settings.empty()) return std::optional<modeling::Scene>();
  const sim::Result<std::string> text = take.sceneOf(frame);
  if (!text) return text.problem();
  const std::string source = options.take + " (its scene)";
  const auto before = modeling::parseScene(*text, source);
  if (!before) return before.problem();
  const auto after = modeling::parseScene(*text, source, options.settings);
  if (!after) return after.problem();
  tell(after->notes);
  if (const sim::Status possible = modeling::checkChange(before->scene, after->scene); !possible)
    return sim::Problem{"--set " + possible.problem().place, possible.problem().what,
                        possible.problem().remedy};
  return std::optional(after->scene);
}

/// What is inside an obstacle that stands still, now that a setting has put it there.
void tellWhatIsInside(const modeling::Continuation& from) {
  sim::Network network = from.simulation->network();
  network.positions = from.simulation->snapshot().positions;
  const modeling::Conditions conditions = modeling::conditionsOf(from.scene, network.materials);
  const std::vector<sim::Collider>& colliders = conditions.environment.colliders;
  for (std::uint32_t c = 0; c < colliders.size(); ++c) {
    const bool moves = std::ranges::any_of(conditions.tracks, [&](const sim::Track& track) {
      return sim::drivesCollider(track.target) && track.object == c;
    });
    if (moves || !colliders[c].activeAt(from.simulation->time())) continue;
    const std::vector<modeling::NodeInside> deepest = modeling::deepestNodes(network, colliders[c]);
    for (std::size_t part = 0; part < deepest.size(); ++part) {
      if (!(deepest[part].depth > 0.0)) continue;
      const modeling::Overlap overlap{.kind = modeling::Overlap::Kind::partInObstacle,
                                      .part = network.partNames[part],
                                      .other = colliders[c].name,
                                      .depth = deepest[part].depth,
                                      .at = network.positions[deepest[part].node],
                                      .mend = {}};
      std::cerr << "warning: " << modeling::printable(modeling::sentence(overlap)) << '\n';
    }
  }
}

ExitStatus branch(const ResumeOptions& options) {
  const Stopwatch stopwatch;
  if (const sim::Status status = checkBranch(options); !status) return complain(status.problem());
  const auto take = sim::TakeReader::open(options.take);
  if (!take) return complain(take.problem());
  const sim::Result<std::size_t> frame = frameOf(options, **take);
  if (!frame) return complain(frame.problem());
  const sim::Result<std::optional<modeling::Scene>> changed = changedScene(options, **take, *frame);
  if (!changed) return complain(changed.problem());
  const auto events = eventsUpTo(**take, *frame);
  if (!events) return complain(events.problem());
  sim::Result<modeling::Continuation> from = [&] {
    Progress progress("going back to frame " + std::to_string(*frame));
    return modeling::continueFrom(**take, *frame, *changed ? &**changed : nullptr, options.threads,
                                  [&](double share) {
                                    progress.show(share);
                                    return true;
                                  });
  }();
  if (!from) return complain(from.problem());
  if (from->changed) tellWhatIsInside(*from);
  const double until = options.until.value_or(from->scene.output.duration);
  sim::Result<modeling::Recording> recording =
      modeling::branchTake(**take, *frame, *from, until, options.branch);
  if (!recording) return complain(recording.problem());
  recording->countEarlier(*events);
  return runAndReport(*from->simulation, *recording, stopwatch,
                      {from->scene.solver.method, options.threads, options.report});
}

ExitStatus resume(const ResumeOptions& options) {
  const Stopwatch stopwatch;
  if (const sim::Status status = checkOutputs(options); !status) return complain(status.problem());
  sim::Result<Resumable> from = readTake(options.take);
  if (!from) return complain(from.problem());
  modeling::Conditions conditions = modeling::conditionsOf(from->scene, from->network.materials);
  conditions.settings.threads = options.threads;
  auto simulation = sim::Simulation::create(std::move(from->network), std::move(conditions.environment),
                                            std::move(conditions.tracks), conditions.settings);
  if (!simulation) return complain(simulation.problem());
  if (from->frame) {
    if (const sim::Status status = (*simulation)->restore(from->checkpoint); !status)
      return complain(
          {options.take, "its last checkpoint: " + status.problem().what, status.problem().remedy});
  }
  // Last, because it cuts off what stands behind the checkpoint.
  auto take = from->frame ? sim::TakeWriter::continueAfter(options.take, *from->frame)
                          : sim::TakeWriter::create(options.take, from->header, (*simulation)->network());
  if (!take) return complain(take.problem());

  const auto begin = from->frame ? &modeling::Recording::ofContinuedRun : &modeling::Recording::ofNewRun;
  modeling::Recording recording =
      begin(**simulation, std::move(take).value(),
            {from->header.framesPerSecond, options.until.value_or(from->scene.output.duration)});
  recording.countEarlier(from->events);
  return runAndReport(**simulation, recording, stopwatch,
                      {from->scene.solver.method, options.threads, options.report});
}

ExitStatus resumeOrBranch(const ResumeOptions& options) {
  if (options.from || options.time) return branch(options);
  if (options.branch.empty() && options.settings.empty()) return resume(options);
  return complain({"command line", "--take and --set need a frame to go on from", "add --from or --time"});
}

}  // namespace

Command resumeCommand() {
  const auto options = std::make_shared<ResumeOptions>();
  // CLI11 from 2.4 on takes a word and an option of one name for the same, so the word is in capitals.
  return {.name = "resume",
          .help = "Go on with a run that was killed, or past its end",
          .options = {{.name = "TAKE",
                       .target = &options->take,
                       .help = "What the run recorded; without --from or --time it is continued in place",
                       .required = true},
                      {"--from", &options->from,
                       "Go on from this frame, counted from 0, in a take beside the old"},
                      {.name = "--time",
                       .target = &options->time,
                       .help = "The same, from the frame nearest to these seconds",
                       .excludes = "--from"},
                      {"--take", &options->branch, "File of the take beside the old"},
                      {.name = "--set",
                       .target = &options->settings,
                       .help = "PATH=VALUE: go on with a value of the scene changed, e.g. "
                               "environment.gravity=[0,0,-4905]",
                       .oneAtATime = true},
                      {.name = "--until",
                       .target = &options->until,
                       .help = "Seconds; left out: what the run was started for",
                       .range = Range{0.0, 1e9}},
                      {"--report", &options->report, "File for the report (JSON)"},
                      threadsOption(options->threads),
                      forceOption(options->force)},
          .run = [options] { return resumeOrBranch(*options); }};
}

}  // namespace app
