#include "ui/session/session.h"

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <fstream>
#include <iterator>

#include <catch2/catch.hpp>

#include "modeling/run/recording.h"
#include "tests/ui/window_scenes.h"

namespace {

using modeling::Scene;
using tests::becomesTrue;
using tests::fallingSlab;

bool isDone(const ui::Session& session) {
  return session.run()->phase == ui::RunPhase::done;
}

std::vector<char> bytesOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

using Fixture = tests::SessionFixture;

TEST_CASE("A scene is built by itself and shown at rest") {
  Fixture fixture;
  fixture.session.document().reset(fallingSlab(), {});
  REQUIRE(becomesTrue([&] { return fixture.session.shown().moment != nullptr; }));
  CHECK(fixture.session.shown().network->nodeCount() == 32);
  CHECK_FALSE(fixture.session.shown().recorded);
}

TEST_CASE("A run records all its frames, which can be looked at in any order") {
  Fixture fixture;
  ui::Session& session = fixture.session;
  session.document().reset(fallingSlab(), {});
  fixture.simulateToEnd();
  REQUIRE(session.takes().size() == 1);
  const std::shared_ptr<ui::Footage> footage = session.takes()[0].footage;
  REQUIRE(footage->frameCount() == 11);
  for (const std::size_t frame : {std::size_t{7}, std::size_t{0}, std::size_t{10}, std::size_t{3}}) {
    session.playback().seek(frame);
    REQUIRE(becomesTrue([&] { return session.shown().moment->time == footage->note(frame).time; }));
    CHECK(session.shown().recorded);
  }
  // What memory and file hold is the same.
  const auto file = ui::Footage::open(footage->file());
  REQUIRE(file);
  for (std::size_t frame = 0; frame < footage->frameCount(); ++frame) {
    const auto read = (*file)->frame(frame);
    REQUIRE(read);
    CHECK((*read)->stepCount == footage->held(frame)->stepCount);
    CHECK((*read)->time == footage->held(frame)->time);
  }
}

TEST_CASE("A take is stale once the scene moves otherwise, and fresh again after undo") {
  Fixture fixture;
  ui::Session& session = fixture.session;
  session.document().reset(fallingSlab(), {});
  fixture.simulateToEnd();
  CHECK_FALSE(session.takes()[0].stale);
  session.document().edit("Camera", [](Scene& scene) { scene.view.camera = modeling::Camera{}; });
  CHECK_FALSE(session.takes()[0].stale);
  session.document().edit("Gravity", [](Scene& scene) { scene.environment.gravity.z() = -100.0; });
  CHECK(session.takes()[0].stale);
  session.document().undoStack().undo();
  CHECK_FALSE(session.takes()[0].stale);
}

TEST_CASE("A run can be paused, stepped and stopped, and keeps what it recorded") {
  Fixture fixture;
  ui::Session& session = fixture.session;
  Scene scene = fallingSlab();
  scene.output.duration = 1000.0;
  session.document().reset(scene, {});
  session.simulate();
  REQUIRE(becomesTrue([&] { return session.run()->footage && session.run()->footage->frameCount() > 3; }));
  session.pauseRun(true);
  REQUIRE(becomesTrue([&] { return session.run()->phase == ui::RunPhase::paused; }));
  const std::uint64_t steps = session.run()->newest->stepCount;
  session.stepRun();
  REQUIRE(becomesTrue([&] { return session.run()->newest->stepCount == steps + 1; }));
  const std::size_t frames = session.run()->footage->frameCount();
  session.stepRunToFrame();
  REQUIRE(becomesTrue([&] { return session.run()->footage->frameCount() == frames + 1; }));
  session.stopRun();
  REQUIRE(becomesTrue([&] { return isDone(session); }));
  const auto reader = sim::TakeReader::open(session.takes()[0].footage->file());
  REQUIRE(reader);
  CHECK((*reader)->frameCount() == frames + 1);
  CHECK((*reader)->outcome() == "stopped");
}

TEST_CASE("The window leaves the same file as a run without one, byte for byte") {
  Fixture fixture;
  ui::Session& session = fixture.session;
  const Scene scene = tests::breakingSlab();
  session.document().reset(scene, {});
  fixture.simulateToEnd();
  const std::filesystem::path seen = session.takes()[0].footage->file();

  auto built = modeling::build(scene, {});
  REQUIRE(built);
  auto simulation = sim::Simulation::create(built->network, built->conditions.environment,
                                            built->conditions.tracks, built->conditions.settings);
  REQUIRE(simulation);
  const std::filesystem::path unseen = seen.parent_path() / "unseen.take";
  auto take = modeling::createTake(unseen, built->scene, built->network);
  REQUIRE(take);
  auto recording = modeling::Recording::ofNewRun(**simulation, std::move(take).value(),
                                                 {scene.output.fps, scene.output.duration});
  REQUIRE(recording.run({}));
  CHECK(recording.breaks() > 0);
  CHECK(bytesOf(seen) == bytesOf(unseen));
}

TEST_CASE("A run stopped between two frames ends in a frame that it can be continued from") {
  Fixture fixture;
  ui::Session& session = fixture.session;
  Scene scene = fallingSlab();
  scene.output.duration = 1000.0;
  session.document().reset(scene, {});
  session.simulate();
  REQUIRE(becomesTrue([&] { return session.run()->footage && session.run()->footage->frameCount() > 3; }));
  session.stepRunToFrame();
  REQUIRE(becomesTrue([&] { return session.run()->phase == ui::RunPhase::paused; }));
  const std::uint64_t steps = session.run()->newest->stepCount;
  session.stepRun();
  REQUIRE(becomesTrue([&] { return session.run()->newest->stepCount == steps + 1; }));
  session.stopRun();
  REQUIRE(becomesTrue([&] { return isDone(session); }));
  const std::shared_ptr<ui::Footage> footage = session.takes()[0].footage;
  CHECK(footage->held(footage->frameCount() - 1)->stepCount == steps + 1);
  session.playback().toLast();
  session.continueFromFrame(false);
  REQUIRE(becomesTrue([&] { return session.takes().size() == 2 && session.run()->newest; }));
  CHECK_FALSE(session.run()->problem);
  CHECK(session.run()->newest->stepCount > steps);
  session.stopRun();
  REQUIRE(becomesTrue([&] { return isDone(session); }));
}

TEST_CASE("A scene that cannot be built says where and why") {
  Fixture fixture;
  ui::Session& session = fixture.session;
  Scene scene = fallingSlab();
  scene.parts[0].material = "glass";
  session.document().reset(scene, {});
  REQUIRE(becomesTrue([&] { return session.preview()->problem.has_value(); }));
  CHECK(session.preview()->problem->place == "parts[0].material");
}

TEST_CASE("Ending the program in the middle of a run takes less than a second and leaves a whole take") {
  QTemporaryDir folder;
  std::filesystem::path file;
  QElapsedTimer clock;
  {
    ui::Session session{std::filesystem::path(folder.path().toStdString())};
    Scene scene = fallingSlab();
    scene.output.duration = 1000.0;
    session.document().reset(scene, {});
    session.simulate();
    REQUIRE(becomesTrue([&] { return session.run()->footage && session.run()->footage->frameCount() > 3; }));
    file = session.run()->footage->file();
    clock.start();
  }
  CHECK(clock.elapsed() < 1000);
  const auto reader = sim::TakeReader::open(file);
  REQUIRE(reader);
  CHECK((*reader)->frameCount() > 3);
  CHECK((*reader)->droppedBytes() == 0);
}

TEST_CASE("A take continued as it was ends in the same bits, and with another scene in others") {
  Fixture fixture;
  ui::Session& session = fixture.session;
  session.document().reset(fallingSlab(), {});
  fixture.simulateToEnd();
  const std::uint64_t whole = session.run()->stateHash;
  session.playback().seek(4);
  session.continueFromFrame(false);
  REQUIRE(becomesTrue([&] { return isDone(session) && session.takes().size() == 2; }));
  CHECK(session.run()->stateHash == whole);
  const std::shared_ptr<ui::Footage> continued = session.takes()[1].footage;
  REQUIRE(continued->frameCount() == 11);
  // As they stand in the files: a take that is not on the timeline holds no frames.
  const auto positionsIn = [](ui::Footage& take, std::size_t frame) {
    take.letGo();
    const auto moment = take.frame(frame);
    REQUIRE(moment);
    return (*moment)->positions;
  };
  for (std::size_t frame = 0; frame < 11; ++frame)
    CHECK(positionsIn(*continued, frame) == positionsIn(*session.takes()[0].footage, frame));
  CHECK(session.takes()[1].continuedAt);

  session.takes().select(0);
  session.playback().seek(4);
  session.document().edit("Gravity", [](Scene& scene) { scene.environment.gravity.z() = 500.0; });
  session.continueFromFrame(true);
  REQUIRE(becomesTrue([&] { return isDone(session) && session.takes().size() == 3; }));
  CHECK(session.run()->stateHash != whole);
  CHECK(positionsIn(*session.takes()[2].footage, 4) == positionsIn(*continued, 4));
  CHECK(positionsIn(*session.takes()[2].footage, 10) != positionsIn(*continued, 10));
}

}  // namespace
