#include "modeling/exchange/continuation.h"

#include <algorithm>

#include "modeling/scene/build.h"
#include "modeling/scene/read_obstacles.h"
#include "modeling/scene/scene_file.h"
#include "modeling/text/json_text.h"
#include "sim/base/text_hash.h"

namespace modeling {
namespace {

using sim::Problem;

/// Asked so often whether to go on: what falls between is done in much less than a second.
constexpr double kStepsPerLook = 16.0;

const Problem kStopped{"", "it was stopped before it was done", ""};
const char* const kRunAgain = "run the changed scene from the start";

/// What is seen of it but does nothing.
SceneMaterial withoutLook(SceneMaterial material) {
  material.preset.clear();
  material.values.look = {};
  material.values.source.clear();
  return material;
}

bool sameSubstance(const SceneMaterial& left, const SceneMaterial& right) {
  return withoutLook(left) == withoutLook(right);
}

/// Of two scenes of which one can go on by the other.
bool movesAlike(const Scene& left, const Scene& right) {
  return left.environment == right.environment && left.tracks == right.tracks && left.solver == right.solver;
}

sim::Result<Scene> parsedSceneOf(const sim::TakeReader& take, std::size_t frame) {
  const sim::Result<std::string> text = take.sceneOf(frame);
  if (!text) return text.problem();
  if (text->empty()) return Problem{"", "this take does not say which scene it was made from", ""};
  auto file = parseScene(*text, "the take's scene");
  if (!file) return file.problem();
  return std::move(file->scene);
}

sim::Result<std::unique_ptr<sim::Simulation>> simulationOf(const sim::TakeReader& take, const Scene& scene,
                                                           int threads) {
  Conditions conditions = conditionsOf(scene, take.network().materials);
  conditions.settings.threads = threads;
  return sim::Simulation::create(take.network(), std::move(conditions.environment),
                                 std::move(conditions.tracks), conditions.settings);
}

/// Restores the nearest checkpoint that is of the frame's own scene. Without one the run begins anew, if that
/// is where the frame came from.
sim::Status restoreNearest(const sim::TakeReader& take, std::size_t frame, sim::Simulation& simulation) {
  const sim::Result<std::string> scene = take.sceneOf(frame);
  const auto sameRun = [&](std::size_t other) {
    const sim::Result<std::string> its = take.sceneOf(other);
    return its.ok() && *its == *scene;
  };
  std::vector<std::size_t> checkpoints = take.checkpointFrames();
  std::erase_if(checkpoints, [&](std::size_t other) { return other > frame || !sameRun(other); });
  for (auto nearest = checkpoints.rbegin(); nearest != checkpoints.rend(); ++nearest) {
    const auto checkpoint = take.checkpoint(*nearest);
    if (checkpoint && simulation.restore(*checkpoint)) return sim::Done{};
  }
  if (sameRun(0)) return sim::Done{};
  return Problem{"", "there is no checkpoint to reach frame " + std::to_string(frame) + " from",
                 "go on from a later frame"};
}

sim::Status runTo(sim::Simulation& simulation, const sim::Snapshot& frame, const KeepGoing& keepGoing) {
  const double start = simulation.time();
  while (simulation.stepCount() < frame.stepCount && simulation.time() < frame.time) {
    const double next = simulation.time() + kStepsPerLook * simulation.step();
    if (const sim::Status status = simulation.advanceTo(std::min(next, frame.time)); !status) return status;
    const double share = (simulation.time() - start) / (frame.time - start);
    if (keepGoing && !keepGoing(std::min(share, 1.0))) return kStopped;
  }
  simulation.drainBreakEvents();
  if (simulation.stepCount() == frame.stepCount && simulation.time() == frame.time) return sim::Done{};
  return Problem{"", "the run does not come to this frame again on this machine",
                 "go on from a frame with a checkpoint"};
}

sim::Status copyFrame(const sim::TakeReader& take, std::size_t frame, sim::TakeWriter& writer) {
  const auto snapshot = take.frame(frame);
  if (!snapshot) return snapshot.problem();
  const auto events = take.eventsOf(frame);
  if (!events) return events.problem();
  return writer.appendFrame(**snapshot, *events);
}

/// With the checkpoints and changes of scene on the way.
sim::Status copyFrames(const sim::TakeReader& take, std::size_t count, sim::TakeWriter& writer,
                       std::string scene, const KeepGoing& keepGoing) {
  const std::vector<std::size_t> checkpoints = take.checkpointFrames();
  for (std::size_t frame = 0; frame < count; ++frame) {
    if (keepGoing && !keepGoing(static_cast<double>(frame) / static_cast<double>(count))) return kStopped;
    const sim::Result<std::string> its = take.sceneOf(frame);
    if (!its) return its.problem();
    if (*its != scene) {
      if (const sim::Status begun = writer.beginScene(*its); !begun) return begun;
      scene = *its;
    }
    if (const sim::Status copied = copyFrame(take, frame, writer); !copied) return copied;
    if (!std::ranges::binary_search(checkpoints, frame)) continue;
    // A damaged one is only one less.
    const auto checkpoint = take.checkpoint(frame);
    if (!checkpoint) continue;
    if (const sim::Status copied = writer.appendCheckpoint(*checkpoint); !copied) return copied;
  }
  return sim::Done{};
}

/// The frame itself, as the first one of the changed run, or what is only seen differently from now on.
sim::Status beginScene(const sim::TakeReader& take, std::size_t frame, const Continuation& from,
                       const std::string& scene, sim::TakeWriter& writer) {
  if (!from.changed) {
    const sim::Result<std::string> before = take.sceneOf(frame);
    return before && *before == scene ? sim::Status(sim::Done{}) : writer.appendScene(scene);
  }
  if (frame > 0) {
    if (const sim::Status begun = writer.beginScene(scene); !begun) return begun;
  }
  const auto events = take.eventsOf(frame);
  if (!events) return events.problem();
  return writer.appendFrame(from.simulation->snapshot(), *events);
}

}  // namespace

sim::Status checkChange(const Scene& before, const Scene& after) {
  if (const sim::Status status = checkScene(after); !status) return status;
  if (before.parts != after.parts) return Problem{"parts", "the parts are not those of the take", kRunAgain};
  if (before.glue != after.glue) return Problem{"glue", "the glue is not that of the take", kRunAgain};
  if (!std::ranges::equal(before.materials, after.materials, sameSubstance))
    return Problem{"materials", "the materials are not those of the take", kRunAgain};
  if (before.solver.seed != after.solver.seed)
    return Problem{"solver.seed", "the thresholds are not those of the take", kRunAgain};
  if (before.output.fps != after.output.fps) {
    return Problem{"output.fps", "a take has as many frames a second all along",
                   "leave them at " + shortestNumber(before.output.fps)};
  }
  return sim::Done{};
}

sim::Result<Continuation> continueFrom(const sim::TakeReader& take, std::size_t frame, const Scene* changed,
                                       int threads, const KeepGoing& keepGoing) {
  const auto snapshot = take.frame(frame);
  if (!snapshot) return snapshot.problem();
  sim::Result<Scene> scene = parsedSceneOf(take, frame);
  if (!scene) return scene.problem();
  Scene after;
  if (changed != nullptr) {
    if (const sim::Status possible = checkChange(*scene, *changed); !possible) return possible.problem();
    after = *changed;
    if (const sim::Status known = takeOverSurfaces(*scene, after); !known) return known.problem();
  }
  auto simulation = simulationOf(take, *scene, threads);
  if (!simulation) return simulation.problem();
  if (const sim::Status restored = restoreNearest(take, frame, **simulation); !restored)
    return restored.problem();
  if (const sim::Status there = runTo(**simulation, **snapshot, keepGoing); !there) return there.problem();
  if (changed == nullptr) return Continuation{std::move(simulation).value(), std::move(scene).value(), false};
  if (movesAlike(after, *scene)) return Continuation{std::move(simulation).value(), std::move(after), false};
  auto other = simulationOf(take, after, threads);
  if (!other) return other.problem();
  if (const sim::Status taken = (*other)->takeOver(**simulation); !taken) return taken.problem();
  return Continuation{std::move(other).value(), std::move(after), true};
}

sim::Result<Recording> branchTake(const sim::TakeReader& take, std::size_t frame, const Continuation& from,
                                  double until, const std::filesystem::path& path,
                                  const KeepGoing& keepGoing) {
  const std::string scene = recordedText(from.scene);
  sim::TakeHeader header = take.header();
  const sim::Result<std::string> first = take.sceneOf(0);
  if (!first) return first.problem();
  header.scene = from.changed && frame == 0 ? scene : *first;
  header.sceneHash = sim::textHash(header.scene);
  auto writer = sim::TakeWriter::create(path, header, take.network());
  if (!writer) return writer.problem();
  const std::size_t copies = from.changed ? frame : frame + 1;
  if (const sim::Status copied = copyFrames(take, copies, **writer, *first, keepGoing); !copied)
    return copied.problem();
  if (const sim::Status begun = beginScene(take, frame, from, scene, **writer); !begun)
    return begun.problem();
  const sim::Status kept = (*writer)->appendCheckpoint(from.simulation->checkpoint());
  if (!kept) return kept.problem();
  return Recording::ofContinuedRun(*from.simulation, std::move(writer).value(),
                                   {header.framesPerSecond, until});
}

}  // namespace modeling
