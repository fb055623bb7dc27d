#include "ui/session/live_run.h"

#include <algorithm>
#include <cmath>

#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "modeling/text/text_file.h"
#include "sim/take/frame_times.h"

namespace ui {
namespace {

using namespace std::chrono_literals;
using Seconds = std::chrono::duration<double>;

/// An order waits no longer than this and one step.
constexpr double kSliceSeconds = 4e-3;
/// Views are made for a screen: no more often than it is drawn, and taking no more than a tenth of the time.
constexpr auto kViewInterval = 15ms;
constexpr int kViewShare = 9;
/// Of the past in measured rates, at each measurement.
constexpr double kInertia = 0.8;

sim::TakeHeader headerOf(const modeling::Scene& scene) {
  sim::TakeHeader header;
  header.scene = modeling::writeScene(modeling::withoutPresets(scene));
  header.sceneHash = modeling::textHash(header.scene);
  header.framesPerSecond = scene.output.fps;
  header.seed = scene.solver.seed;
  return header;
}

}  // namespace

LiveRun::LiveRun(std::uint64_t number, RunPlan plan, const Pace& pace)
    : number_(number), plan_(std::move(plan)), pace_(pace), scene_(plan_.scene) {}

LiveRun::~LiveRun() = default;

void LiveRun::prepare(const Interrupt& cancelled) {
  const sim::Status status = plan_.continuation ? startContinued(cancelled) : startFresh();
  if (!status) {
    fail(status.problem());
    return;
  }
  phase_ = RunPhase::running;
  restartClock();
  changed_ = true;
}

sim::Status LiveRun::startFresh() {
  std::shared_ptr<const modeling::BuiltScene> built = plan_.built;
  if (!built) {
    sim::Result<modeling::BuiltScene> made = modeling::build(plan_.scene, plan_.folder);
    if (!made) return made.problem();
    built = std::make_shared<const modeling::BuiltScene>(std::move(made).value());
  }
  notes_ = built->warnings;
  plan_.scene = scene_ = built->scene;
  modeling::Conditions conditions = built->conditions;
  conditions.settings.threads = plan_.threads;
  auto simulation = sim::Simulation::create(built->network, std::move(conditions.environment),
                                            std::move(conditions.tracks), conditions.settings);
  if (!simulation) return simulation.problem();
  simulation_ = std::move(simulation).value();
  // The footage shares the built scene's network.
  footage_ = std::make_shared<Footage>(std::shared_ptr<const sim::Network>(built, &built->network),
                                       plan_.scene, plan_.take);
  plan_.built.reset();
  if (const sim::Status started = startTake(); !started) return started;
  return recordFrame();
}

sim::Status LiveRun::startTake() {
  auto take = sim::TakeWriter::create(plan_.take, headerOf(plan_.scene), simulation_->network());
  if (!take) return take.problem();
  take_ = std::move(take).value();
  framesSinceCheckpoint_ = sim::kFramesPerCheckpoint;
  return sim::Done{};
}

std::optional<LiveRun::Clock::time_point> LiveRun::due() const {
  if (!isRunning()) return std::nullopt;
  const Clock::time_point now = Clock::now();
  const double ahead = secondsAhead();
  return ahead > 0.0 ? now + std::chrono::duration_cast<Clock::duration>(Seconds(std::min(ahead, 1.0))) : now;
}

/// How far the simulation is ahead of the clock it keeps to, in seconds of the clock.
double LiveRun::secondsAhead() const {
  if (!pace_.timeScale) return 0.0;
  const double elapsed = Seconds(Clock::now() - paceStart_).count();
  return (simulation_->time() - paceTime_) / *pace_.timeScale - elapsed;
}

void LiveRun::restartPace() {
  paceStart_ = Clock::now();
  paceTime_ = simulation_ ? simulation_->time() : 0.0;
}

void LiveRun::restartClock() {
  restartPace();
  frameStart_ = paceStart_;
  frameTime_ = paceTime_;
}

bool LiveRun::ended() const {
  return sim::hasReached(simulation_->time(), simulation_->step(), plan_.scene.output.duration);
}

void LiveRun::advance(const Interrupt& interrupt) {
  if (ended()) {
    finish("done");
    return;
  }
  if (secondsAhead() > 0.0) return;
  const double until = plan_.scene.output.duration;
  const double frame =
      std::min(sim::nextFrameTime(simulation_->time(), simulation_->step(), plan_.scene.output.fps), until);
  const Clock::time_point start = Clock::now();
  while (!interrupt() && Seconds(Clock::now() - start).count() < kSliceSeconds) {
    if (!stepTowards(frame)) return;
    if (!sim::hasReached(simulation_->time(), simulation_->step(), frame)) continue;
    if (const sim::Status recorded = recordFrame(); !recorded) pauseBecause(recorded.problem());
    if (ended()) finish("done");
    return;
  }
  // A computer too slow for the pace does not try to catch up later.
  if (secondsAhead() < -0.1) restartPace();
}

/// A few steps at a time, so that the clock is not asked after each of many short ones.
bool LiveRun::stepTowards(double frame) {
  const std::uint64_t before = simulation_->stepCount();
  const Clock::time_point start = Clock::now();
  const double steps = std::clamp(std::floor(0.25 * kSliceSeconds / secondsPerStep_), 1.0, 1000.0);
  const double target = std::min(frame, simulation_->time() + (steps - 0.5) * simulation_->step());
  const sim::Status status = simulation_->advanceTo(target);
  const auto made = static_cast<double>(std::max<std::uint64_t>(simulation_->stepCount() - before, 1));
  const double seconds = Seconds(Clock::now() - start).count() / made;
  secondsPerStep_ = std::max(kInertia * secondsPerStep_ + (1.0 - kInertia) * seconds, 1e-7);
  if (status) return true;
  static_cast<void>(recordFrame());
  fail(status.problem());
  return false;
}

sim::Status LiveRun::recordFrame() {
  std::vector<sim::BreakEvent> breaks = simulation_->drainBreakEvents();
  unrecorded_.insert(unrecorded_.end(), breaks.begin(), breaks.end());
  const auto moment = std::make_shared<const sim::Snapshot>(simulation_->snapshot());
  if (const sim::Status written = writeFrame(*moment); !written) return written;
  FrameNote note;
  const Clock::time_point now = Clock::now();
  const double elapsed = Seconds(now - frameStart_).count();
  const sim::Work& work = simulation_->work();
  if (footage_->frameCount() > 0 && elapsed > 0.0) {
    note.realTimeFactor = (simulation_->time() - frameTime_) / elapsed;
    const double past = realTimeFactor_ > 0.0 ? kInertia : 0.0;
    realTimeFactor_ = past * realTimeFactor_ + (1.0 - past) * note.realTimeFactor;
  }
  note.bondsEvaluated = work.bondsEvaluated - frameWork_.bondsEvaluated;
  note.bondsSkipped = work.bondsSkipped - frameWork_.bondsSkipped;
  frameWork_ = work;
  frameStart_ = now;
  frameTime_ = simulation_->time();
  footage_->append(moment, note, std::exchange(unrecorded_, {}));
  newest_ = moment;
  changed_ = true;
  if (pauseAtFrame_) setPaused(true);
  return sim::Done{};
}

/// What was performed stands in the take as well, so that it can be continued and run again.
sim::Status LiveRun::writeScene() {
  if (sceneWritten_) return sim::Done{};
  const sim::Status written = take_->appendScene(headerOf(scene_).scene);
  sceneWritten_ = written.ok();
  return written;
}

sim::Status LiveRun::writeFrame(const sim::Snapshot& moment) {
  if (const sim::Status written = writeScene(); !written) return written;
  if (const sim::Status written = take_->appendFrame(moment, unrecorded_); !written) return written;
  if (++framesSinceCheckpoint_ < sim::kFramesPerCheckpoint && !ended()) return sim::Done{};
  // A checkpoint that could not be written is tried again with the next frame; the frame itself stands.
  if (take_->appendCheckpoint(simulation_->checkpoint())) framesSinceCheckpoint_ = 0;
  return sim::Done{};
}

void LiveRun::setPaused(bool paused) {
  if (phase_ != RunPhase::running && phase_ != RunPhase::paused) return;
  pauseAtFrame_ = false;
  if (!paused && unwritten_ && !retry()) return;
  phase_ = paused ? RunPhase::paused : RunPhase::running;
  restartClock();
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
  if (phase_ != RunPhase::running && phase_ != RunPhase::paused) return;
  setPaused(false);
  pauseAtFrame_ = true;
}

void LiveRun::stepOnce() {
  if (phase_ != RunPhase::paused || (unwritten_ && !retry())) return;
  const double frame = sim::nextFrameTime(simulation_->time(), simulation_->step(), plan_.scene.output.fps);
  if (const sim::Status status = simulation_->stepOnce(); !status) {
    fail(status.problem());
    return;
  }
  look();
  if (!sim::hasReached(simulation_->time(), simulation_->step(), frame)) return;
  if (const sim::Status recorded = recordFrame(); !recorded) pauseBecause(recorded.problem());
}

void LiveRun::stop() {
  if (phase_ != RunPhase::running && phase_ != RunPhase::paused) return;
  if (unwritten_) retry();
  finish("stopped");
}

void LiveRun::finish(const std::string& outcome) {
  if (take_) {
    static_cast<void>(writeScene());
    if (framesSinceCheckpoint_ > 0 && outcome == "stopped")
      static_cast<void>(take_->appendCheckpoint(simulation_->checkpoint()));
    if (const sim::Status finished = take_->finish(outcome); !finished) problem_ = finished.problem();
    take_.reset();
  }
  phase_ = RunPhase::done;
  look();
}

void LiveRun::fail(const sim::Problem& problem) {
  if (take_) static_cast<void>(take_->finish(problem.line()));
  take_.reset();
  problem_ = problem;
  phase_ = RunPhase::failed;
  changed_ = true;
}

void LiveRun::setPace(const Pace& pace) {
  pace_ = pace;
  restartClock();
}

/// Takes a picture of the present moment for the next view.
void LiveRun::look() {
  if (simulation_) newest_ = std::make_shared<const sim::Snapshot>(simulation_->snapshot());
  changed_ = true;
}

std::shared_ptr<const RunView> LiveRun::newView() {
  const Clock::time_point now = Clock::now();
  if (!changed_) {
    const auto wait = std::max<Clock::duration>(kViewInterval, kViewShare * tellingTook_);
    if (phase_ != RunPhase::running || now - toldAt_ < wait) return nullptr;
    look();
  }
  changed_ = false;
  auto view = std::make_shared<RunView>();
  view->run = number_;
  view->phase = phase_;
  view->footage = footage_;
  view->newest = newest_;
  view->until = plan_.scene.output.duration;
  view->performed = performed_;
  view->notes = notes_;
  view->problem = problem_;
  view->realTimeFactor = realTimeFactor_;
  if (simulation_) {
    view->step = simulation_->step();
    view->brokenBonds = simulation_->brokenBondCount();
    view->work = simulation_->work();
    view->memoryBytes = simulation_->memoryBytes();
    if (phase_ == RunPhase::done) view->stateHash = simulation_->stateHash();
    const double left = view->until - simulation_->time();
    if (realTimeFactor_ > 0.0 && phase_ == RunPhase::running) view->secondsLeft = left / realTimeFactor_;
  }
  toldAt_ = Clock::now();
  tellingTook_ = toldAt_ - now;
  return view;
}

}  // namespace ui
