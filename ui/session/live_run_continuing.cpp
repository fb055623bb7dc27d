#include "modeling/exchange/continuation.h"
#include "ui/session/live_run.h"

namespace ui {

/// The take up to the frame is copied into a new one, and what was simulated since the last checkpoint is
/// simulated again.
sim::Status LiveRun::startContinued(const Interrupt& cancelled) {
  const RunPlan::Continuation& from = *plan_.continuation;
  const auto opened = sim::TakeReader::open(from.take->file());
  if (!opened) return opened.problem();
  const sim::TakeReader& reader = **opened;
  const auto keepGoing = [&](double) { return !cancelled(); };
  auto continued = modeling::continueFrom(reader, from.frame, from.changed ? &plan_.scene : nullptr,
                                          plan_.threads, keepGoing);
  if (!continued) return continued.problem();
  auto take = modeling::branchTake(reader, from.frame, *continued, plan_.take, keepGoing);
  if (!take) return take.problem();
  take_ = std::move(take).value();
  simulation_ = std::move(continued->simulation);
  scene_ = std::move(continued->scene);
  // How long it runs and how often it is recorded is what the plan says, as it moves nothing.
  scene_.output = plan_.scene.output;
  plan_.scene = scene_;
  frameWork_ = simulation_->work();
  return showCopiedFrames(reader);
}

sim::Status LiveRun::showCopiedFrames(const sim::TakeReader& reader) {
  const RunPlan::Continuation& from = *plan_.continuation;
  footage_ = std::make_shared<Footage>(from.take->network(), scene_, plan_.take);
  for (std::size_t frame = 0; frame <= from.frame; ++frame) {
    const auto moment = from.take->frame(frame);
    if (!moment) return moment.problem();
    const auto events = reader.eventsOf(frame);
    if (!events) return events.problem();
    footage_->append(*moment, from.take->note(frame), *events);
    newest_ = *moment;
  }
  return sim::Done{};
}

}  // namespace ui
