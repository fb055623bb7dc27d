#include <algorithm>

#include "sim/take/frame_times.h"
#include "ui/session/live_run.h"

namespace ui {
namespace {

/// What was recorded is repeated so many steps at a time, between which it can be given up.
constexpr double kStepsAtOnce = 100.0;

/// The last one at or before a frame.
std::optional<std::size_t> checkpointBefore(const sim::TakeReader& take, std::size_t frame) {
  const std::vector<std::size_t> frames = take.checkpointFrames();
  const auto after = std::upper_bound(frames.begin(), frames.end(), frame);
  if (after == frames.begin()) return std::nullopt;
  return *(after - 1);
}

/// The network stays what it was when the take was begun, and so does how it is stepped; what acts on it may
/// be another.
modeling::Scene continuedScene(modeling::Scene was, const modeling::Scene& now) {
  was.environment = now.environment;
  was.tracks = now.tracks;
  was.output = now.output;
  was.view = now.view;
  was.name = now.name;
  return was;
}

}  // namespace

/// Goes back to the last checkpoint, repeats what was recorded since, and from there on lets the plan's scene
/// act.
sim::Status LiveRun::startContinued(const Interrupt& cancelled) {
  const std::shared_ptr<Footage> from = plan_.continuation->from;
  const std::size_t frame = plan_.continuation->frame;
  const auto opened = sim::TakeReader::open(from->file());
  if (!opened) return opened.problem();
  const sim::TakeReader& reader = **opened;
  const modeling::Scene was = from->scene();
  modeling::Conditions past = modeling::conditionsOf(was, from->network()->materials);
  past.settings.threads = plan_.threads;
  auto simulation = sim::Simulation::create(*from->network(), std::move(past.environment),
                                            std::move(past.tracks), past.settings);
  if (!simulation) return simulation.problem();
  simulation_ = std::move(simulation).value();
  if (const std::optional<std::size_t> checkpoint = checkpointBefore(reader, frame)) {
    const auto state = reader.checkpoint(*checkpoint);
    if (!state) return state.problem();
    if (const sim::Status restored = simulation_->restore(*state); !restored) return restored;
  }
  if (const sim::Status there = repeatUntil(from->note(frame).time, cancelled); !there) return there;
  scene_ = continuedScene(was, plan_.scene);
  plan_.scene = scene_;
  modeling::Conditions conditions = modeling::conditionsOf(scene_, from->network()->materials);
  const sim::Status planned =
      simulation_->replan(std::move(conditions.environment), std::move(conditions.tracks));
  if (!planned) return planned;
  return copyFrames(*from, reader, frame);
}

sim::Status LiveRun::repeatUntil(double time, const Interrupt& cancelled) {
  while (!sim::hasReached(simulation_->time(), simulation_->step(), time)) {
    if (cancelled()) return sim::Problem{"", "the run was given up before it went on", ""};
    const double piece = simulation_->time() + kStepsAtOnce * simulation_->step();
    if (const sim::Status status = simulation_->advanceTo(std::min(time, piece)); !status) return status;
  }
  // What broke on the way stands in the old take, and is copied from there.
  static_cast<void>(simulation_->drainBreakEvents());
  return sim::Done{};
}

sim::Status LiveRun::copyFrames(Footage& from, const sim::TakeReader& reader, std::size_t last) {
  footage_ = std::make_shared<Footage>(from.network(), scene_, plan_.take);
  if (const sim::Status started = startTake(); !started) return started;
  for (std::size_t frame = 0; frame <= last; ++frame) {
    const auto moment = from.frame(frame);
    if (!moment) return moment.problem();
    const auto events = reader.eventsOf(frame);
    if (!events) return events.problem();
    if (const sim::Status written = take_->appendFrame(**moment, *events); !written) return written;
    footage_->append(*moment, from.note(frame), *events);
    newest_ = *moment;
  }
  frameWork_ = simulation_->work();
  // From here on it can be continued again; the frames before are those of the old take.
  return take_->appendCheckpoint(simulation_->checkpoint());
}

}  // namespace ui
