#include <numbers>

#include <catch2/catch.hpp>

#include "tests/support/change_broken.h"
#include "tests/support/grid_network.h"
#include "tests/support/memory_take.h"
#include "ui/picture/take_pictures.h"

namespace {

using sim::Vec3;
using tests::MemoryTake;

/// A block that slides along x by 10 cm in three frames, beside a ball that a track lifts and a box that
/// turns.
MemoryTake slidingBlock(const std::string& view) {
  const std::string scene = R"({
    "smithereens": 1,
    "materials": {"test": {"youngsModulus": 1e8, "look": {"outside": [0.1, 0.2, 0.3]}}},
    "parts": [{"name": "block", "kind": "slab", "material": "test", "size": [3, 3, 3]}],
    "environment": {"colliders": [
      {"name": "ball", "kind": "sphere", "radius": 2.5},
      {"name": "box", "kind": "box", "halfSize": [1, 2, 3], "visible": false}]},
    "tracks": [
      {"target": "collider.ball.position", "keys": [[0, [0, 0, 0]], [2, [0, 0, 8]]]},
      {"target": "collider.box.rotation", "keys": [[0, [0, 0, 0]], [2, [0, 0, 180]]]}])" +
                            view + "}";
  const sim::Network network = tests::gridNetwork(3, 3, 3);
  std::vector<sim::Snapshot> frames;
  for (int number = 0; number < 3; ++number) {
    sim::Snapshot frame = sim::momentAtRest(network);
    frame.time = number;
    for (Vec3& position : frame.positions) position.x() += 5.0 * number;
    frames.push_back(std::move(frame));
  }
  return {network, std::move(frames), scene};
}

TEST_CASE("a picture of a frame has the surface, the looks, and colliders where their tracks have them") {
  const MemoryTake take = slidingBlock("");
  auto pictures = ui::TakePictures::create(ui::framesOf(take).value(), 0, 2, 1.5);
  REQUIRE(pictures.ok());
  const auto scene = pictures->sceneOf(1);
  REQUIRE(scene.ok());
  CHECK(scene->surface.faces.size() == 54);
  REQUIRE(scene->looks.size() == 1);
  CHECK(scene->looks[0].outside[2] == 0.3);
  REQUIRE(scene->colliders.size() == 2);
  CHECK(scene->colliders[0].shape == sim::ColliderShape(sim::SphereShape{2.5}));
  CHECK(scene->colliders[0].position.z() == Approx(4.0));
  CHECK(scene->colliders[1].shape == sim::ColliderShape(sim::BoxShape{Vec3(1, 2, 3)}));
  CHECK_FALSE(scene->colliders[1].visible);
  CHECK((scene->colliders[1].rotation * Vec3::UnitX() - Vec3::UnitY()).norm() < 1e-12);
}

TEST_CASE(
    "a picture can have the level surface of the nodes, and asks for an image only where one is named") {
  const MemoryTake take = slidingBlock(R"(, "view": {"picture": {"surface": "level"}})");
  auto pictures =
      ui::TakePictures::create(ui::framesOf(take).value(), 0, 2, 1.5, {.shutter = 0.5, .aperture = {}});
  REQUIRE(pictures.ok());
  const auto scene = pictures->sceneOf(1);
  REQUIRE(scene.ok());
  CHECK(scene->surface.faces.size() > 500);
  CHECK(scene->endPoints.size() == scene->surface.points.size());
  CHECK_FALSE(scene->environment);
  const std::vector<std::string> missing{"view.picture.environment.image=nowhere.hdr"};
  auto frames = ui::framesOf(take, missing).value();
  frames.folder = "/no/such/folder";
  const auto lit = ui::TakePictures::create(std::move(frames), 0, 2, 1.5);
  REQUIRE_FALSE(lit.ok());
  CHECK(lit.problem().place == "/no/such/folder/nowhere.hdr");
  CHECK_FALSE(ui::framesOf(take, {"view.picture.backdrop.kind=environment"}).ok());
}

TEST_CASE("without a view, one camera sees all frames of a sequence") {
  const MemoryTake take = slidingBlock("");
  auto pictures = ui::TakePictures::create(ui::framesOf(take).value(), 0, 2, 1.5);
  REQUIRE(pictures.ok());
  const auto first = pictures->sceneOf(0).value();
  const auto last = pictures->sceneOf(2).value();
  CHECK(first.camera.position == last.camera.position);
  CHECK(first.subject.min() == Vec3(0, 0, 0));
  CHECK(first.subject.max() == Vec3(13, 3, 3));
}

TEST_CASE("the scene's view is the camera") {
  const MemoryTake take = slidingBlock(
      R"(, "view": {"camera": {"position": [9, -50, 20], "target": [1, 2, 3], "fieldOfView": 30}})");
  auto pictures = ui::TakePictures::create(ui::framesOf(take).value(), 1, 1, 1.5);
  REQUIRE(pictures.ok());
  const auto scene = pictures->sceneOf(1).value();
  CHECK(scene.camera.position == Vec3(9, -50, 20));
  CHECK(scene.camera.target == Vec3(1, 2, 3));
  CHECK(scene.camera.verticalFieldOfView == Approx(std::numbers::pi / 6.0));
}

TEST_CASE("what is whole is framed whole, and far splinters do not make the picture small") {
  sim::Snapshot moment = sim::momentAtRest(tests::gridNetwork(4, 3, 2));
  moment.positions[0] = Vec3(-50, 0, 0);
  CHECK(ui::boxOfMost(moment).min() == Vec3(-50, 0, 0));
  tests::changeBroken(moment, [](sim::Broken& broken) { broken.fragmentOfNode[0] = 7; });
  const ui::Box box = ui::boxOfMost(moment);
  CHECK(box.min() == Vec3(0, 0, 0));
  CHECK(box.max() == Vec3(4, 3, 2));
}

TEST_CASE("a take whose scene cannot be read is refused in words") {
  const sim::Network network = tests::gridNetwork(1, 1, 1);
  const MemoryTake take(network, {sim::momentAtRest(network)}, "{\"smithereens\": 1, \"nam\": 3}");
  CHECK_FALSE(ui::framesOf(take).ok());
}

}  // namespace
