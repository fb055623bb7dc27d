#include "ui/session/live_run.h"

#include "sim/take/frame_times.h"

namespace ui {
namespace {

/// s of the clock: an order waits no longer than this and one step.
constexpr double kSliceSeconds = 4e-3;

}  // namespace

LiveRun::LiveRun(std::uint64_t number, RunPlan plan, const Pace& pace)
    : number_(number), plan_(std::move(plan)), pace_(pace) {}

LiveRun::~LiveRun() = default;

void LiveRun::prepare(const Interrupt& cancelled) {
  if (const sim::Status started = start(cancelled); !started) {
    fail(started.problem());
    return;
  }
  phase_ = RunPhase::running;
  restartClocks();
  telling_.tellAtOnce();
}

sim::Status LiveRun::start(const Interrupt& cancelled) {
  sim::Result<StartedRun> started = startRun(plan_, cancelled);
  plan_ = {};
  if (!started) return started.problem();
  run_ = std::move(started).value();
  performance_.emplace(run_.scene);
  speed_.setWork(run_.simulation->work());
  if (!run_.recording->isRecorded()) return recordFrame();
  newest_ = run_.footage->held(run_.footage->frameCount() - 1);
  return sim::Done{};
}

std::optional<Clock::time_point> LiveRun::due() const {
  if (!isRunning()) return std::nullopt;
  return pace_.due(time());
}

void LiveRun::restartClocks() {
  pace_.restart(time());
  speed_.restart(time());
}

void LiveRun::advance(const Interrupt& interrupt) {
  if (run_.recording->hasEnded()) return finish("done");
  if (pace_.secondsAhead(time()) > 0.0) return;
  const double frame = run_.recording->nextFrameTime();
  const Clock::time_point start = Clock::now();
  while (!interrupt() && std::chrono::duration<double>(Clock::now() - start).count() < kSliceSeconds) {
    if (!stepTowards(frame)) return;
    if (!sim::hasReached(time(), run_.simulation->step(), frame)) continue;
    if (const sim::Status recorded = recordFrame(); !recorded) return pauseBecause(recorded.problem());
    if (run_.recording->hasEnded()) finish("done");
    return;
  }
  pace_.forgiveDelay(time());
}

/// False when the simulation failed.
bool LiveRun::stepTowards(double frame) {
  const sim::Status status = steps_.advance(*run_.simulation, frame, 0.25 * kSliceSeconds);
  if (status) return true;
  // What it looks like when it failed is worth seeing, and no more than that.
  static_cast<void>(recordFrame());
  fail(status.problem());
  return false;
}

sim::Status LiveRun::recordFrame() {
  sim::Result<modeling::Recording::Frame> frame = run_.recording->record();
  if (!frame) return frame.problem();
  const bool first = run_.footage->frameCount() == 0;
  run_.footage->append(frame->moment, speed_.noteFrame(*run_.simulation, first), std::move(frame->breaks));
  newest_ = frame->moment;
  telling_.tellAtOnce();
  if (pauseAtFrame_) setPaused(true);
  return sim::Done{};
}

void LiveRun::setPaused(bool paused) {
  if (!isActive()) return;
  pauseAtFrame_ = false;
  if (!paused && unwritten_ && !retry()) return;
  phase_ = paused ? RunPhase::paused : RunPhase::running;
  restartClocks();
  look();
}

/// The frame that could not be written is written now, before time goes on.
bool LiveRun::retry() {
  problem_.reset();
  unwritten_ = false;
  const sim::Status recorded = recordFrame();
  if (!recorded) pauseBecause(recorded.problem());
  return recorded.ok();
}

/// Where frames cannot be written, nothing is lost by waiting: the run goes on when the person says so.
void LiveRun::pauseBecause(const sim::Problem& problem) {
  setPaused(true);
  unwritten_ = true;
  problem_ = problem;
}

void LiveRun::setPausedAtFrame() {
  if (!isActive()) return;
  setPaused(false);
  pauseAtFrame_ = true;
}

void LiveRun::stepOnce() {
  if (phase_ != RunPhase::paused || (unwritten_ && !retry())) return;
  const double frame = run_.recording->nextFrameTime();
  if (const sim::Status status = run_.simulation->stepOnce(); !status) {
    fail(status.problem());
    return;
  }
  look();
  if (!sim::hasReached(time(), run_.simulation->step(), frame)) return;
  if (const sim::Status recorded = recordFrame(); !recorded) pauseBecause(recorded.problem());
}

void LiveRun::stop() {
  if (!isActive()) return;
  pauseAtFrame_ = false;
  if (!run_.recording->isRecorded()) {
    const sim::Status recorded = recordFrame();
    problem_ = recorded ? std::optional<sim::Problem>() : recorded.problem();
  }
  finish("stopped");
}

void LiveRun::finish(const std::string& outcome) {
  if (const sim::Status finished = run_.recording->finish(outcome); !finished) problem_ = finished.problem();
  phase_ = RunPhase::done;
  look();
}

void LiveRun::fail(const sim::Problem& problem) {
  if (run_.recording) static_cast<void>(run_.recording->fail(problem));
  problem_ = problem;
  phase_ = RunPhase::failed;
  telling_.tellAtOnce();
}

void LiveRun::setPace(const Pace& pace) {
  pace_.setPace(pace, time());
  speed_.restart(time());
}

void LiveRun::perform(const modeling::TargetName& target, const std::vector<modeling::SceneTrackKey>& keys) {
  if (isActive()) takeOver(performance_->perform(*run_.simulation, target, keys));
}

void LiveRun::performCollider(const modeling::SceneCollider& prototype,
                              std::vector<modeling::SceneTrackKey> path) {
  if (isActive() && path.size() >= 2)
    takeOver(performance_->performCollider(*run_.simulation, prototype, std::move(path)));
}

/// What was performed stands in the take as well, so that it can be continued and run again.
void LiveRun::takeOver(const sim::Status& performed) {
  telling_.tellAtOnce();
  if (!performed) {
    run_.notes.push_back(performed.problem().line());
    return;
  }
  run_.recording->setScene(performance_->scene());
  run_.footage->setScene(performance_->scene());
}

/// Takes a picture of the present moment for the next view.
void LiveRun::look() {
  if (run_.simulation) newest_ = std::make_shared<const sim::Snapshot>(run_.simulation->snapshot());
  telling_.tellAtOnce();
}

std::shared_ptr<const RunView> LiveRun::newView() {
  const Clock::time_point begun = Clock::now();
  if (!telling_.isUrgent()) {
    if (phase_ != RunPhase::running || !telling_.isDue()) return nullptr;
    look();
  }
  auto view = std::make_shared<RunView>();
  view->run = number_;
  view->phase = phase_;
  view->footage = run_.footage;
  view->newest = newest_;
  view->notes = run_.notes;
  view->problem = problem_;
  view->realTimeFactor = speed_.realTimeFactor();
  view->until = run_.recording ? run_.recording->plan().until : plan_.scene.output.duration;
  if (performance_) view->performed = performance_->performed();
  if (run_.simulation) {
    const sim::Simulation& simulation = *run_.simulation;
    view->step = simulation.step();
    view->brokenBonds = simulation.brokenBondCount();
    view->work = simulation.work();
    view->memoryBytes = simulation.memoryBytes();
    if (phase_ == RunPhase::done) view->stateHash = simulation.stateHash();
    const double left = view->until - simulation.time();
    if (view->realTimeFactor > 0.0 && phase_ == RunPhase::running)
      view->secondsLeft = left / view->realTimeFactor;
  }
  telling_.told(begun);
  return view;
}

}  // namespace ui
