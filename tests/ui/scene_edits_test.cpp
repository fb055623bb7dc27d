#include "ui/document/scene_edits.h"

#include <catch2/catch.hpp>

#include "modeling/scene/scene_file.h"
#include "tests/modeling/scene_examples.h"

using namespace ui;
using modeling::Scene;

namespace {

/// A pot with a lid and a handle glued to it, a plate, a floor and a ball that a track moves.
Scene pot() {
  const sim::Result<modeling::SceneFile> file = modeling::parseScene(R"({
    "smithereens": 1,
    "materials": {"clay": {}, "glass": {}, "spare": {}},
    "parts": [
      {"name": "pot", "kind": "slab", "size": [4, 4, 4], "material": "clay"},
      {"name": "lid", "kind": "slab", "size": [4, 4, 1], "material": "glass"},
      {"name": "handle", "kind": "slab", "size": [1, 1, 4], "material": "clay"},
      {"name": "plate", "kind": "slab", "size": [8, 8, 1], "material": "glass"}],
    "glue": [{"a": "lid", "b": "pot", "reach": 0.3}, {"a": "handle", "b": "pot", "reach": 0.3}],
    "environment": {"colliders": [{"name": "floor", "kind": "floor"}, {"name": "ball", "kind": "sphere", "radius": 2}]},
    "tracks": [
      {"target": "collider.ball.position", "keys": [[0, [0, 0, 9]]]},
      {"target": "stiffness.scale.glass", "keys": [[0, 1]]},
      {"target": "gravity.scale", "keys": [[0, 1]]}],
    "view": {"hidden": ["lid"], "locked": ["pot", "ball"]}})",
                                                                     "pot");
  if (!file) FAIL(file.problem().line());
  return file->scene;
}

void checkWhole(const Scene& scene) {
  const sim::Status status = modeling::checkScene(scene);
  if (!status) FAIL(status.problem().line());
}

constexpr Item kPot{ItemKind::part, 0};
constexpr Item kLid{ItemKind::part, 1};
constexpr Item kBall{ItemKind::collider, 1};
constexpr Item kGlass{ItemKind::material, 1};

}  // namespace

TEST_CASE("A name is made different by a number", "[scene-edits]") {
  CHECK(uniqueName("cup", {}) == "cup");
  CHECK(uniqueName("cup", {"cup"}) == "cup 2");
  CHECK(uniqueName("cup 2", {"cup", "cup 2"}) == "cup 3");
  CHECK(uniqueName("cup2", {"cup2"}) == "cup2 2");
  CHECK(uniqueName("7", {"7"}) == "7 2");
}

TEST_CASE("What refers to a name follows when it changes", "[scene-edits]") {
  Scene scene = pot();
  rename(scene, kPot, "jar");
  CHECK(scene.glue[0].b == "jar");
  CHECK(scene.glue[1].b == "jar");
  CHECK(scene.view.locked == std::vector<std::string>{"jar", "ball"});
  rename(scene, kLid, "jar");
  CHECK(scene.parts[1].name == "jar 2");
  CHECK(scene.view.hidden == std::vector<std::string>{"jar 2"});
  rename(scene, kBall, "apple");
  CHECK(scene.tracks[0].target.object == "apple");
  CHECK(isLocked(scene, kBall));
  rename(scene, kGlass, "crystal");
  CHECK(scene.parts[3].material == "crystal");
  CHECK(scene.materials[1].values.name == "crystal");
  CHECK(scene.tracks[1].target.object == "crystal");
  checkWhole(scene);
  const Scene before = scene;
  rename(scene, kPot, "");
  rename(scene, {ItemKind::part, 99}, "nothing");
  CHECK(scene == before);
}

TEST_CASE("With a part its glue goes, with a collider or material its tracks", "[scene-edits]") {
  Scene scene = pot();
  const Item gone[] = {kPot};
  remove(scene, gone);
  CHECK(scene.parts.size() == 3);
  CHECK(scene.glue.empty());
  CHECK(scene.view.locked == std::vector<std::string>{"ball"});
  const Item ball[] = {kBall};
  remove(scene, ball);
  CHECK(scene.tracks.size() == 2);
  CHECK(scene.view.locked.empty());
  checkWhole(scene);
}

TEST_CASE("A material in use stays, unless all that is made of it goes too", "[scene-edits]") {
  Scene scene = pot();
  const Scene before = scene;
  const Item glass[] = {kGlass};
  REQUIRE(removalProblem(scene, glass));
  CHECK(removalProblem(scene, glass)->what.find("lid") != std::string::npos);
  CHECK_FALSE(removalProblem(scene, glass)->remedy.empty());
  remove(scene, glass);
  CHECK(scene == before);
  const Item all[] = {kGlass, kLid, {ItemKind::part, 3}};
  CHECK_FALSE(removalProblem(scene, all));
  remove(scene, all);
  CHECK(scene.materials.size() == 2);
  CHECK(scene.parts.size() == 2);
  CHECK(scene.tracks.size() == 2);
  checkWhole(scene);
  const Item spare[] = {{ItemKind::material, 1}};
  remove(scene, spare);
  CHECK(namesOf(scene, ItemKind::material) == std::vector<std::string>{"clay"});
}

TEST_CASE("Copies stand beside the originals, and are glued to each other alike", "[scene-edits]") {
  Scene scene = pot();
  const Item originals[] = {kPot, kLid, kBall, {ItemKind::collider, 0}};
  const std::vector<Item> copies = duplicate(scene, originals, sim::Vec3(10, 0, 0));
  REQUIRE(copies.size() == 4);
  CHECK(nameOf(scene, copies[0]) == "pot 2");
  CHECK(nameOf(scene, copies[2]) == "ball 2");
  CHECK(scene.parts[copies[0].index].worldFromPart.position.x() == 10.0);
  CHECK(scene.environment.colliders[copies[3].index].position.x() == 0.0);
  REQUIRE(scene.glue.size() == 3);
  CHECK(scene.glue[2].a == "lid 2");
  CHECK(scene.glue[2].b == "pot 2");
  checkWhole(scene);
}

TEST_CASE("Lists can be put into another order", "[scene-edits]") {
  Scene scene = pot();
  reorder(scene, kPot, 2);
  CHECK(namesOf(scene, ItemKind::part) == std::vector<std::string>{"lid", "handle", "pot", "plate"});
  reorder(scene, {ItemKind::part, 3}, 0);
  CHECK(namesOf(scene, ItemKind::part) == std::vector<std::string>{"plate", "lid", "handle", "pot"});
  reorder(scene, kPot, 99);
  CHECK(scene.parts.size() == 4);
  checkWhole(scene);
}

TEST_CASE("Parts and colliders can be hidden and locked", "[scene-edits]") {
  Scene scene = pot();
  CHECK(isHidden(scene, kLid));
  setHidden(scene, kLid, false);
  setHidden(scene, kPot, true);
  setHidden(scene, kBall, true);
  CHECK(scene.view.hidden == std::vector<std::string>{"pot"});
  CHECK_FALSE(scene.environment.colliders[1].visible);
  setLocked(scene, kPot, false);
  setLocked(scene, kLid, true);
  CHECK_FALSE(isLocked(scene, kPot));
  CHECK(isLocked(scene, kLid));
  setHidden(scene, kGlass, true);
  CHECK_FALSE(isHidden(scene, kGlass));
  const sim::Result<modeling::SceneFile> again = modeling::parseScene(modeling::writeScene(scene), "again");
  REQUIRE(again);
  CHECK(again->scene == scene);
}
