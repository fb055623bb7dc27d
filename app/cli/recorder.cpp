#include "app/cli/recorder.h"

#include <algorithm>
#include <chrono>
#include <ctime>

#include "sim/take/frame_times.h"

namespace app {
namespace {

double wallClock() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

double cpuClock() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace

Stopwatch::Stopwatch() : wallStart_(wallClock()), cpuStart_(cpuClock()) {}
double Stopwatch::wallSeconds() const {
  return wallClock() - wallStart_;
}
double Stopwatch::cpuSeconds() const {
  return cpuClock() - cpuStart_;
}

Recorder::Recorder(sim::Simulation& simulation, sim::TakeWriter* take, double framesPerSecond)
    : simulation_(simulation), take_(take), framesPerSecond_(framesPerSecond) {}

sim::Status Recorder::begin() {
  framesSinceCheckpoint_ =
      sim::kFramesPerCheckpoint;  // the first frame has one, so that every take can be resumed
  return record(false);
}

void Recorder::takeOver(const std::vector<sim::BreakEvent>& events) {
  count(events);
}

sim::Status Recorder::run(double until, const Watcher& watcher) {
  const sim::Status status = advance(until, watcher);
  if (take_ == nullptr) return status;
  const sim::Status finished = take_->finish(status ? "done" : status.problem().line());
  return status ? finished : status;
}

sim::Status Recorder::advance(double until, const Watcher& watcher) {
  const auto ended = [&] { return sim::hasReached(simulation_.time(), simulation_.step(), until); };
  while (!ended()) {
    const double target = std::min(nextFrameTime(), until);
    if (const sim::Status status = simulation_.advanceTo(target); !status) return status;
    if (const sim::Status status = record(ended()); !status) return status;
    if (watcher) watcher(simulation_);
  }
  return sim::Done{};
}

double Recorder::nextFrameTime() const {
  return sim::nextFrameTime(simulation_.time(), simulation_.step(), framesPerSecond_);
}

sim::Status Recorder::record(bool last) {
  const std::vector<sim::BreakEvent> events = simulation_.drainBreakEvents();
  count(events);
  if (take_ == nullptr) return sim::Done{};
  if (const sim::Status status = take_->appendFrame(simulation_.snapshot(), events); !status) return status;
  if (++framesSinceCheckpoint_ < sim::kFramesPerCheckpoint && !last) return sim::Done{};
  framesSinceCheckpoint_ = 0;
  return take_->appendCheckpoint(simulation_.checkpoint());
}

void Recorder::count(const std::vector<sim::BreakEvent>& events) {
  if (!events.empty() && !firstBreak_) firstBreak_ = events.front().time;
  breaks_ += events.size();
}

}  // namespace app
