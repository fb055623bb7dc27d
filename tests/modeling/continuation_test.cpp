#include "modeling/exchange/continuation.h"

#include <algorithm>

#include <catch2/catch.hpp>

#include "modeling/scene/build.h"
#include "modeling/scene/perform.h"
#include "modeling/scene/scene_file.h"
#include "sim/take/frame_times.h"
#include "tests/modeling/table_scene.h"
#include "tests/sim/take_sample.h"

namespace {

using modeling::continueFrom;
using modeling::Scene;
using sim::Vec3;

constexpr double kFramesPerSecond = 1000.0;
constexpr double kUntil = 0.012;
constexpr std::size_t kFramesPerCheckpoint = 5;

/// The table, on which a ball breaks the vase.
Scene knockedTable() {
  Scene scene = tests::tableScene(sim::Method::velocityVerlet);
  scene.output.fps = kFramesPerSecond;
  modeling::SceneCollider ball;
  ball.name = "ball";
  ball.form = modeling::SphereShape{1.0};
  modeling::addPerformer(scene, ball, {{0.001, Vec3(13.2, 0.0, 3.0)}, {0.007, Vec3(9.0, 0.0, 3.0)}});
  return scene;
}

class Recording {
 public:
  explicit Recording(const std::filesystem::path& path, const Scene& scene)
      : scene_(scene), simulation_(tests::started(scene, 1)) {
    const sim::TakeHeader header{modeling::writeScene(scene), "", kFramesPerSecond, scene.solver.seed};
    writer_ = sim::TakeWriter::create(path, header, simulation_->network()).value();
    record();
  }

  sim::Simulation& simulation() { return *simulation_; }
  void runTo(double until) {
    while (!sim::hasReached(simulation_->time(), simulation_->step(), until)) {
      const double next = sim::nextFrameTime(simulation_->time(), simulation_->step(), kFramesPerSecond);
      REQUIRE(simulation_->advanceTo(std::min(next, until)).ok());
      record();
    }
  }
  void perform(const char* target, double value) {
    modeling::performKey(scene_, modeling::TargetName::parse(target).value(),
                         modeling::performTime(*simulation_), value);
    const auto conditions = modeling::conditionsOf(scene_, simulation_->network().materials);
    REQUIRE(simulation_->replan(conditions.environment, conditions.tracks).ok());
    REQUIRE(writer_->appendScene(modeling::writeScene(scene_)).ok());
  }

 private:
  void record() {
    REQUIRE(writer_->appendFrame(simulation_->snapshot(), simulation_->drainBreakEvents()).ok());
    if (frames_++ % kFramesPerCheckpoint == 0)
      REQUIRE(writer_->appendCheckpoint(simulation_->checkpoint()).ok());
  }

  Scene scene_;
  std::unique_ptr<sim::Simulation> simulation_;
  std::unique_ptr<sim::TakeWriter> writer_;
  std::size_t frames_ = 0;
};

std::unique_ptr<sim::TakeReader> opened(const std::filesystem::path& path) {
  auto take = sim::TakeReader::open(path);
  if (!take) FAIL(take.problem().line());
  return std::move(take).value();
}

modeling::Continuation continued(const sim::TakeReader& take, std::size_t frame,
                                 const Scene* changed = nullptr, int threads = 1) {
  auto continuation = continueFrom(take, frame, changed, threads);
  if (!continuation) FAIL(continuation.problem().line());
  return std::move(continuation).value();
}

void checkAt(const sim::Simulation& simulation, const sim::TakeReader& take, std::size_t frame) {
  const sim::SnapshotPointer recorded = take.frame(frame).value();
  const sim::Snapshot now = simulation.snapshot();
  CHECK(now.stepCount == recorded->stepCount);
  CHECK(now.positions == recorded->positions);
  CHECK(now.velocities == recorded->velocities);
  CHECK(now.broken->version == recorded->broken->version);
}

/// Under other conditions the half kick that ends at the frame is done before they change, and rounded once
/// more.
void checkNear(const sim::Simulation& simulation, const sim::TakeReader& take, std::size_t frame) {
  const sim::SnapshotPointer recorded = take.frame(frame).value();
  const sim::Snapshot now = simulation.snapshot();
  CHECK(now.stepCount == recorded->stepCount);
  CHECK(now.positions == recorded->positions);
  CHECK(now.broken->version == recorded->broken->version);
  double furthest = 0.0;
  for (std::size_t node = 0; node < now.velocities.size(); ++node)
    furthest = std::max(furthest, (now.velocities[node] - recorded->velocities[node]).norm());
  CHECK(furthest < 1e-13);  // cm/s; nodes move at up to some hundred
}

TEST_CASE("a run goes on from any frame to the same bits") {
  const tests::ScratchFolder folder;
  Recording recording(folder.file("knock.take"), knockedTable());
  recording.runTo(kUntil);
  REQUIRE(recording.simulation().brokenBondCount() > 0);
  const auto take = opened(folder.file("knock.take"));
  REQUIRE(take->frameCount() > 10);
  for (std::size_t frame = 0; frame < take->frameCount(); frame += 3) {
    const modeling::Continuation again = continued(*take, frame, nullptr, frame % 2 == 0 ? 1 : 3);
    CHECK_FALSE(again.changed);
    checkAt(*again.simulation, *take, frame);
    REQUIRE(again.simulation->advanceTo(kUntil).ok());
    CHECK(again.simulation->stateHash() == recording.simulation().stateHash());
  }
  CHECK_FALSE(continueFrom(*take, take->frameCount(), nullptr, 1).ok());
}

TEST_CASE("a run that someone played with goes on from any frame as it was played") {
  const tests::ScratchFolder folder;
  Recording recording(folder.file("played.take"), knockedTable());
  recording.runTo(0.0023);
  recording.perform("gravity.scale", 4.0);
  recording.runTo(0.005);
  recording.perform("stiffness.scale", 0.5);
  recording.runTo(kUntil);
  const auto take = opened(folder.file("played.take"));
  for (const std::size_t frame : {0U, 3U, 8U, 12U}) {
    const modeling::Continuation again = continued(*take, frame);
    checkAt(*again.simulation, *take, frame);
    REQUIRE(again.simulation->advanceTo(kUntil).ok());
    CHECK(again.simulation->stateHash() == recording.simulation().stateHash());
  }
}

/// What the account of energy cannot explain, relative to what there is.
double unexplained(const sim::Simulation& simulation) {
  const sim::Energy energy = simulation.snapshot().ledger.energy;
  return std::abs(energy.residual) / (energy.kinetic + energy.elastic + energy.dissipated + energy.released +
                                      std::abs(energy.outsideWork));
}

TEST_CASE("a run goes on under another gravity, and its account of energy holds") {
  const tests::ScratchFolder folder;
  Recording recording(folder.file("knock.take"), knockedTable());
  recording.runTo(kUntil);
  const auto take = opened(folder.file("knock.take"));
  Scene changed = knockedTable();
  changed.environment.gravity = Vec3(0.0, 0.0, 3000.0);
  constexpr std::size_t kFrame = 7;
  const modeling::Continuation other = continued(*take, kFrame, &changed);
  CHECK(other.changed);
  checkAt(*other.simulation, *take, kFrame);
  const std::filesystem::path branch = folder.file("branch.take");
  {
    auto record = modeling::branchTake(*take, kFrame, other, kUntil, branch);
    REQUIRE(record.ok());
    const double before = unexplained(*other.simulation);
    for (int frame = 0; frame < 4; ++frame) {
      REQUIRE(other.simulation->advanceTo(record->nextFrameTime()).ok());
      REQUIRE(record->record().ok());
    }
    CHECK(other.simulation->stateHash() != recording.simulation().stateHash());
    CHECK(unexplained(*other.simulation) < before + 0.02);
  }
  // The new take goes on like any other, on both sides of the change.
  const auto both = opened(branch);
  REQUIRE(both->frameCount() == kFrame + 5);
  CHECK(modeling::parseScene(both->header().scene, "branch")->scene == changed);
  CHECK(both->sceneOf(kFrame - 1).value() == take->header().scene);
  CHECK(both->sceneOf(kFrame).value() == both->header().scene);
  for (const std::size_t frame : {2U, 6U, 7U, 9U}) {
    const modeling::Continuation again = continued(*both, frame);
    checkAt(*again.simulation, *both, frame);
  }
  const modeling::Continuation again = continued(*both, 8);
  REQUIRE(again.simulation->advanceTo(0.011).ok());
  CHECK(again.simulation->stateHash() == other.simulation->stateHash());
  // A frame may be the first of the change, too.
  const modeling::Continuation atOnce = continued(*take, 0, &changed);
  REQUIRE(modeling::branchTake(*take, 0, atOnce, kUntil, folder.file("at-once.take")).ok());
  CHECK(opened(folder.file("at-once.take"))->frameCount() == 1);
}

TEST_CASE("whatever may change, the run goes on soundly") {
  const tests::ScratchFolder folder;
  Recording recording(folder.file("knock.take"), knockedTable());
  recording.runTo(kUntil);
  const auto take = opened(folder.file("knock.take"));
  Scene changed = knockedTable();
  modeling::Solver& solver = changed.solver;
  SECTION("another method") {
    solver.method = GENERATE(sim::Method::rungeKutta, sim::Method::symplecticEuler);
  }
  SECTION("a tolerance") {
    solver.step.tolerance = 1e-3;
  }
  SECTION("nothing skipped") {
    solver.skip.sleep = solver.skip.rigid = false;
  }
  SECTION("no contact") {
    solver.contact.between = false;
  }
  SECTION("another contact") {
    solver.contact.self = true;
    solver.contact.friction = 1.0;
    solver.contact.stiffnessScale = 0.5;
  }
  SECTION("no colliders") {
    changed.environment.colliders.clear();
    changed.tracks.clear();
  }
  SECTION("one collider more, where the block is") {
    modeling::SceneCollider box;
    box.name = "box";
    box.form = modeling::BoxShape{};
    changed.environment.colliders.push_back(box);
  }
  SECTION("softer") {
    changed.tracks.push_back({modeling::TargetName::parse("stiffness.scale").value(), {{0.0, 0.2}}});
  }
  const modeling::Continuation other = continued(*take, 9, &changed);
  REQUIRE(other.changed);
  checkNear(*other.simulation, *take, 9);
  const double before = unexplained(*other.simulation);
  const double rise = other.simulation->maxRise();
  const sim::Status ran = other.simulation->advanceTo(0.02);
  if (!ran) FAIL(ran.problem().line());
  CHECK(unexplained(*other.simulation) < before + 0.03);
  CHECK(other.simulation->maxRise() < rise + 0.03);
  // And can be resumed.
  const std::vector<std::byte> checkpoint = other.simulation->checkpoint();
  const std::uint64_t hash = other.simulation->stateHash();
  REQUIRE(other.simulation->restore(checkpoint).ok());
  CHECK(other.simulation->stateHash() == hash);
}

TEST_CASE("what the network was made from cannot change, and what is only seen can") {
  const Scene scene = knockedTable();
  const auto placeOf = [&](auto&& change) {
    Scene changed = scene;
    change(changed);
    const sim::Status status = modeling::checkChange(scene, changed);
    return status ? std::string() : status.problem().place;
  };
  CHECK(placeOf([](Scene& s) { s.parts[0].worldFromPart.position.x() += 1.0; }) == "parts");
  CHECK(placeOf([](Scene& s) { s.glue.push_back({"block", "vase", 1.0, {}, {}, {}}); }) == "glue");
  CHECK(placeOf([](Scene& s) { s.materials[1].values.threshold.mean = 0.5; }) == "materials");
  CHECK(placeOf([](Scene& s) { s.solver.seed = 7; }) == "solver.seed");
  CHECK(placeOf([](Scene& s) { s.output.fps = 24.0; }) == "output.fps");
  CHECK(placeOf([](Scene& s) { s.tracks[0].keys.clear(); }) == "tracks[0].keys");
  CHECK(placeOf([](Scene& s) { s.materials[1].values.look.glaze = 0.0; }).empty());
  CHECK(placeOf([](Scene& s) { s.output.duration = 9.0; }).empty());
}

TEST_CASE("a scene that only looks different goes on to the same bits") {
  const tests::ScratchFolder folder;
  Recording recording(folder.file("knock.take"), knockedTable());
  recording.runTo(0.006);
  const auto take = opened(folder.file("knock.take"));
  Scene seen = knockedTable();
  seen.materials[0].values.look.glaze = 0.9;
  seen.output.duration = 5.0;
  const modeling::Continuation again = continued(*take, 4, &seen);
  CHECK_FALSE(again.changed);
  REQUIRE(modeling::branchTake(*take, 4, again, 0.006, folder.file("seen.take")).ok());
  REQUIRE(again.simulation->advanceTo(0.006).ok());
  CHECK(again.simulation->stateHash() == recording.simulation().stateHash());
  const auto other = opened(folder.file("seen.take"));
  REQUIRE(other->frameCount() == 5);
  CHECK(modeling::parseScene(other->header().scene, "seen")->scene == seen);
}

TEST_CASE("going back to a frame can be stopped") {
  const tests::ScratchFolder folder;
  Recording recording(folder.file("knock.take"), knockedTable());
  recording.runTo(0.005);
  const auto take = opened(folder.file("knock.take"));
  double last = -1.0;
  const auto stopped = continueFrom(*take, 4, nullptr, 1, [&](double share) {
    CHECK(share >= last);
    last = share;
    return share < 0.5;
  });
  REQUIRE_FALSE(stopped.ok());
  CHECK(last >= 0.5);
  CHECK(last < 1.0);
}

}  // namespace
