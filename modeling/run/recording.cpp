#include "modeling/run/recording.h"

#include <algorithm>

#include "modeling/scene/scene_file.h"
#include "sim/base/text_hash.h"
#include "sim/take/frame_times.h"

namespace modeling {

std::string recordedText(const Scene& scene) {
  return writeScene(withoutPresets(scene));
}

sim::TakeHeader takeHeaderOf(const Scene& scene) {
  sim::TakeHeader header;
  header.scene = recordedText(scene);
  header.sceneHash = sim::textHash(header.scene);
  header.framesPerSecond = scene.output.fps;
  header.seed = scene.solver.seed;
  return header;
}

sim::Result<std::unique_ptr<sim::TakeWriter>> createTake(const std::filesystem::path& path,
                                                         const Scene& scene, const sim::Network& network) {
  return sim::TakeWriter::create(path, takeHeaderOf(scene), network);
}

Recording Recording::ofNewRun(sim::Simulation& simulation, std::unique_ptr<sim::TakeWriter> take, Plan plan) {
  Recording recording(simulation, std::move(take), plan);
  recording.framesSinceCheckpoint_ = sim::kFramesPerCheckpoint;
  return recording;
}

Recording Recording::ofContinuedRun(sim::Simulation& simulation, std::unique_ptr<sim::TakeWriter> take,
                                    Plan plan) {
  Recording recording(simulation, std::move(take), plan);
  recording.recordedStep_ = simulation.stepCount();
  return recording;
}

double Recording::nextFrameTime() const {
  const double next = sim::nextFrameTime(simulation_.time(), simulation_.step(), plan_.framesPerSecond);
  return std::min(next, plan_.until);
}

bool Recording::hasEnded() const {
  return sim::hasReached(simulation_.time(), simulation_.step(), plan_.until);
}

sim::Result<Recording::Frame> Recording::record() {
  const std::vector<sim::BreakEvent> fresh = simulation_.drainBreakEvents();
  count(fresh);
  unrecorded_.insert(unrecorded_.end(), fresh.begin(), fresh.end());
  Frame frame;
  if (take_) {
    if (const sim::Status written = writePerformed(); !written) return written.problem();
    frame.moment = std::make_shared<const sim::Snapshot>(simulation_.snapshot());
    if (const sim::Status written = take_->appendFrame(*frame.moment, unrecorded_); !written)
      return written.problem();
    if (++framesSinceCheckpoint_ >= sim::kFramesPerCheckpoint || hasEnded()) writeCheckpoint();
  }
  recordedStep_ = simulation_.stepCount();
  frame.breaks = std::exchange(unrecorded_, {});
  return frame;
}

/// The count goes on where it fails, so that the next frame tries again.
void Recording::writeCheckpoint() {
  if (take_->appendCheckpoint(simulation_.checkpoint())) framesSinceCheckpoint_ = 0;
}

sim::Status Recording::writePerformed() {
  if (!unwrittenScene_) return sim::Done{};
  const sim::Status written = take_->appendScene(recordedText(*unwrittenScene_));
  if (written) unwrittenScene_.reset();
  return written;
}

sim::Status Recording::finish(const std::string& outcome) {
  if (!take_) return sim::Done{};
  const sim::Status scene = writePerformed();
  if (isRecorded() && framesSinceCheckpoint_ > 0) writeCheckpoint();
  const sim::Status finished = close(outcome);
  return scene ? finished : scene;
}

sim::Status Recording::fail(const sim::Problem& problem) {
  return take_ ? close(problem.line()) : sim::Status(sim::Done{});
}

sim::Status Recording::close(const std::string& outcome) {
  const sim::Status finished = take_->finish(outcome);
  nodesLeftOut_ = take_->nodesLeftOut();
  take_.reset();
  return finished;
}

sim::Status Recording::run(const std::function<void(const sim::Simulation&)>& watcher) {
  const sim::Status ran = advanceToEnd(watcher);
  if (ran) return finish("done");
  // Where the take cannot be written, it cannot say so either.
  static_cast<void>(fail(ran.problem()));
  return ran;
}

sim::Status Recording::advanceToEnd(const std::function<void(const sim::Simulation&)>& watcher) {
  if (!recordedStep_) {
    if (const auto recorded = record(); !recorded) return recorded.problem();
  }
  std::function<void()> afterStep;
  if (watcher) afterStep = [&] { watcher(simulation_); };
  while (!hasEnded()) {
    if (const sim::Status status = simulation_.advanceTo(nextFrameTime(), afterStep); !status) return status;
    if (const auto recorded = record(); !recorded) return recorded.problem();
  }
  return sim::Done{};
}

void Recording::count(const std::vector<sim::BreakEvent>& breaks) {
  if (!breaks.empty() && !firstBreak_) firstBreak_ = breaks.front().time;
  breaks_ += breaks.size();
}

}  // namespace modeling
