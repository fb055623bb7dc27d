#include "modeling/run/recording.h"

#include <catch2/catch.hpp>

#include "modeling/scene/perform.h"
#include "modeling/scene/scene_file.h"
#include "sim/take/frame_times.h"
#include "tests/modeling/table_scene.h"
#include "tests/sim/take_sample.h"

namespace {

using modeling::Recording;
using modeling::Scene;
using sim::Vec3;

/// A table on which a ball breaks the vase.
Scene knockedTable() {
  Scene scene = tests::tableScene(sim::Method::velocityVerlet);
  scene.output = {2000.0, 0.0081};
  modeling::SceneCollider ball;
  ball.name = "ball";
  ball.form = modeling::SphereShape{1.0};
  modeling::addPerformer(scene, ball, {{0.001, Vec3(13.2, 0.0, 3.0)}, {0.007, Vec3(9.0, 0.0, 3.0)}});
  return scene;
}

/// A take that can be told to refuse what comes.
class RefusingTake final : public sim::TakeWriter {
 public:
  explicit RefusingTake(std::unique_ptr<sim::TakeWriter> take) : take_(std::move(take)) {}

  bool refusesFrames = false;
  bool refusesCheckpoints = false;

  sim::Status appendFrame(const sim::Snapshot& frame, const std::vector<sim::BreakEvent>& events) override {
    return refusesFrames ? kFull : take_->appendFrame(frame, events);
  }
  sim::Status appendCheckpoint(const std::vector<std::byte>& checkpoint) override {
    return refusesCheckpoints ? kFull : take_->appendCheckpoint(checkpoint);
  }
  std::uint64_t nodesLeftOut() const override { return take_->nodesLeftOut(); }
  sim::Status appendScene(const std::string& scene) override { return take_->appendScene(scene); }
  sim::Status beginScene(const std::string& scene) override { return take_->beginScene(scene); }
  sim::Status finish(const std::string& outcome) override { return take_->finish(outcome); }

 private:
  inline static const sim::Problem kFull{"", "the disk is full", "make room"};
  std::unique_ptr<sim::TakeWriter> take_;
};

/// A run of the table and its recording.
struct Run {
  explicit Run(const std::filesystem::path& path, const Scene& scene = knockedTable())
      : simulation(tests::started(scene, 1)) {
    auto writer = modeling::createTake(path, scene, simulation->network());
    REQUIRE(writer.ok());
    auto refusing = std::make_unique<RefusingTake>(std::move(writer).value());
    take = refusing.get();
    recording = std::make_unique<Recording>(
        Recording::ofNewRun(*simulation, std::move(refusing), {scene.output.fps, scene.output.duration}));
  }

  /// To the next frame, in pieces shorter than a frame, as the window advances it.
  void advance() {
    const double frame = recording->nextFrameTime();
    while (!sim::hasReached(simulation->time(), simulation->step(), frame)) REQUIRE(simulation->stepOnce());
  }

  std::unique_ptr<sim::Simulation> simulation;
  RefusingTake* take = nullptr;  ///< the recording's
  std::unique_ptr<Recording> recording;
};

std::unique_ptr<sim::TakeReader> opened(const std::filesystem::path& path) {
  auto take = sim::TakeReader::open(path);
  if (!take) FAIL(take.problem().line());
  return std::move(take).value();
}

TEST_CASE("a run leaves the same file, byte for byte, whoever advances it and in whatever pieces") {
  const tests::ScratchFolder folder;
  Run atOnce(folder.file("at-once.take"));
  REQUIRE(atOnce.recording->run({}).ok());
  Run piecewise(folder.file("piecewise.take"));
  REQUIRE(piecewise.recording->record().ok());
  while (!piecewise.recording->hasEnded()) {
    piecewise.advance();
    REQUIRE(piecewise.recording->record().ok());
  }
  REQUIRE(piecewise.recording->finish("done").ok());
  CHECK(tests::fileBytes(folder.file("at-once.take")) == tests::fileBytes(folder.file("piecewise.take")));

  const auto take = opened(folder.file("at-once.take"));
  // 0 to 8 ms by halves, and the end between two of them.
  CHECK(take->frameCount() == 18);
  CHECK(take->outcome() == "done");
  CHECK(take->checkpointFrames() == std::vector<std::size_t>{0, 12, 17});
  CHECK(take->events()->size() == atOnce.recording->breaks());
  CHECK(take->events()->front().time == atOnce.recording->firstBreak());
  CHECK(atOnce.recording->breaks() == atOnce.simulation->brokenBondCount());
}

TEST_CASE("a checkpoint that cannot be written costs no frame and is tried again with the next one") {
  const tests::ScratchFolder folder;
  Run run(folder.file("run.take"));
  run.take->refusesCheckpoints = true;
  for (int frame = 0; frame < 3; ++frame) {
    REQUIRE(run.recording->record().ok());
    run.advance();
  }
  run.take->refusesCheckpoints = false;
  REQUIRE(run.recording->record().ok());
  run.advance();
  REQUIRE(run.recording->record().ok());
  const auto take = opened(folder.file("run.take"));
  CHECK(take->frameCount() == 5);
  CHECK(take->checkpointFrames() == std::vector<std::size_t>{3});
}

TEST_CASE("a frame that cannot be written is written later, with all that broke") {
  const tests::ScratchFolder folder;
  Run run(folder.file("run.take"));
  REQUIRE(run.recording->record().ok());
  bool refused = false;
  while (!run.recording->hasEnded()) {
    run.advance();
    if (!refused && run.simulation->brokenBondCount() > 0) {
      refused = true;
      run.take->refusesFrames = true;
      CHECK_FALSE(run.recording->record().ok());
      CHECK_FALSE(run.recording->isRecorded());
      run.take->refusesFrames = false;
    }
    const auto frame = run.recording->record();
    REQUIRE(frame.ok());
    CHECK(run.recording->isRecorded());
  }
  REQUIRE(refused);
  REQUIRE(run.recording->finish("done").ok());
  Run whole(folder.file("whole.take"));
  REQUIRE(whole.recording->run({}).ok());
  CHECK(tests::fileBytes(folder.file("run.take")) == tests::fileBytes(folder.file("whole.take")));
}

TEST_CASE("a run whose take cannot be written ends with the Problem, and the take with what it has") {
  const tests::ScratchFolder folder;
  Run run(folder.file("run.take"));
  // Told of after each step: after the one that is the fifth frame, the disk is full for the sixth.
  const double fifth = 4.0 / run.recording->plan().framesPerSecond;
  const sim::Status ran = run.recording->run([&](const sim::Simulation& now) {
    if (now.time() > fifth + 2.0 * now.step()) run.take->refusesFrames = true;
  });
  REQUIRE_FALSE(ran.ok());
  CHECK(ran.problem().what == "the disk is full");
  const auto take = opened(folder.file("run.take"));
  CHECK(take->frameCount() == 5);
  CHECK(take->outcome() == ran.problem().line());
}

TEST_CASE("a run that is ended ends in a frame it can be resumed from") {
  const tests::ScratchFolder folder;
  Run run(folder.file("run.take"));
  REQUIRE(run.recording->record().ok());
  run.advance();
  REQUIRE(run.recording->record().ok());
  REQUIRE(run.recording->finish("stopped").ok());
  const auto take = opened(folder.file("run.take"));
  CHECK(take->outcome() == "stopped");
  CHECK(take->checkpointFrames() == std::vector<std::size_t>{0, 1});
}

TEST_CASE("what was performed is in the take before the first frame that it makes different") {
  const tests::ScratchFolder folder;
  Run run(folder.file("run.take"));
  REQUIRE(run.recording->record().ok());
  Scene performed = knockedTable();
  modeling::performKey(performed, modeling::TargetName::parse("gravity.scale").value(),
                       modeling::performTime(*run.simulation), 2.0);
  run.recording->setScene(std::make_shared<const Scene>(performed));
  run.advance();
  REQUIRE(run.recording->record().ok());
  const auto take = opened(folder.file("run.take"));
  CHECK(modeling::parseScene(take->header().scene, "take")->scene == performed);
  CHECK(take->header().framesPerSecond == performed.output.fps);
}

TEST_CASE("a run without a take is counted all the same") {
  const Scene scene = knockedTable();
  const auto simulation = tests::started(scene, 1);
  Recording recording = Recording::ofNewRun(*simulation, nullptr, {scene.output.fps, scene.output.duration});
  REQUIRE(recording.run({}).ok());
  CHECK(recording.breaks() == simulation->brokenBondCount());
  CHECK(recording.firstBreak().has_value());
}

}  // namespace
