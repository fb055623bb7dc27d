#include "ui/session/run_start.h"

#include "modeling/exchange/continuation.h"

namespace ui {
namespace {

using modeling::Recording;

sim::Result<std::shared_ptr<const modeling::BuiltScene>> builtOf(const RunPlan& plan,
                                                                 const std::function<bool()>& cancelled) {
  if (plan.built) return plan.built;
  sim::Result<modeling::BuiltScene> made = modeling::build(plan.scene, plan.folder, {{}, cancelled});
  if (!made) return made.problem();
  return std::make_shared<const modeling::BuiltScene>(std::move(made).value());
}

sim::Result<StartedRun> startFresh(const RunPlan& plan, const std::function<bool()>& cancelled) {
  const auto found = builtOf(plan, cancelled);
  if (!found) return found.problem();
  const std::shared_ptr<const modeling::BuiltScene>& built = *found;
  modeling::Conditions conditions = built->conditions;
  conditions.settings.threads = plan.threads;
  auto simulation = sim::Simulation::create(built->network, std::move(conditions.environment),
                                            std::move(conditions.tracks), conditions.settings);
  if (!simulation) return simulation.problem();
  StartedRun run;
  run.simulation = std::move(simulation).value();
  run.scene = built->scene;
  run.notes = built->warnings;
  // The footage shares the built scene's network.
  run.footage = std::make_shared<Footage>(std::shared_ptr<const sim::Network>(built, &built->network),
                                          run.scene, plan.take);
  auto take = modeling::createTake(plan.take, run.scene, built->network);
  if (!take) return take.problem();
  run.recording = std::make_unique<Recording>(Recording::ofNewRun(
      *run.simulation, std::move(take).value(), {run.scene.output.fps, run.scene.output.duration}));
  return run;
}

sim::Status copyFrames(const sim::TakeReader& reader, const RunPlan::Continuation& from, Footage& footage) {
  for (std::size_t frame = 0; frame <= from.frame; ++frame) {
    const auto moment = from.take->frame(frame);
    if (!moment) return moment.problem();
    const auto events = reader.eventsOf(frame);
    if (!events) return events.problem();
    footage.append(*moment, from.take->note(frame), *events);
  }
  return sim::Done{};
}

sim::Result<StartedRun> startContinued(const RunPlan& plan, const std::function<bool()>& cancelled) {
  const RunPlan::Continuation& from = *plan.continuation;
  const auto opened = sim::TakeReader::open(from.take->file());
  if (!opened) return opened.problem();
  const sim::TakeReader& reader = **opened;
  const auto keepGoing = [&](double) { return !cancelled(); };
  auto continued = modeling::continueFrom(reader, from.frame, from.changed ? &plan.scene : nullptr,
                                          plan.threads, keepGoing);
  if (!continued) return continued.problem();
  auto recording =
      modeling::branchTake(reader, from.frame, *continued, plan.scene.output.duration, plan.take, keepGoing);
  if (!recording) return recording.problem();
  StartedRun run;
  run.recording = std::make_unique<Recording>(std::move(recording).value());
  run.simulation = std::move(continued->simulation);
  run.scene = std::move(continued->scene);
  // How long it runs and how often it is recorded is what the plan says, as it moves nothing.
  run.scene.output = plan.scene.output;
  const std::shared_ptr<const sim::Network> network = from.take->network();
  if (!network)
    return sim::Problem{from.take->file().string(), "the take cannot be read any more", "simulate again"};
  run.footage = std::make_shared<Footage>(network, run.scene, plan.take);
  if (const sim::Status copied = copyFrames(reader, from, *run.footage); !copied) return copied.problem();
  return run;
}

}  // namespace

sim::Result<StartedRun> startRun(const RunPlan& plan, const std::function<bool()>& cancelled) {
  return plan.continuation ? startContinued(plan, cancelled) : startFresh(plan, cancelled);
}

}  // namespace ui
