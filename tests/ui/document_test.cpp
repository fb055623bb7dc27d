#include "ui/document/document.h"

#include <catch2/catch.hpp>

#include "ui/document/selection.h"

namespace {

using modeling::Scene;

Scene sceneWithParts(int count) {
  Scene scene;
  for (int i = 0; i < count; ++i) {
    modeling::Part part;
    part.name = "part " + std::to_string(i);
    part.shape = modeling::SlabShape{};
    scene.parts.push_back(part);
  }
  return scene;
}

void moveFirst(Scene& scene, double height) {
  scene.parts.front().worldFromPart.position.z() = height;
}

TEST_CASE("An edit can be undone and redone, and gives the same scene each time") {
  ui::Document document;
  document.reset(sceneWithParts(2), {});
  const Scene before = document.scene();
  document.edit("Move", [](Scene& scene) { moveFirst(scene, 3.0); });
  const Scene after = document.scene();
  REQUIRE(after != before);
  document.undoStack().undo();
  CHECK(document.scene() == before);
  document.undoStack().redo();
  CHECK(document.scene() == after);
}

TEST_CASE("An edit that changes nothing leaves no step behind") {
  ui::Document document;
  document.reset(sceneWithParts(1), {});
  document.edit("Move", [](Scene& scene) { moveFirst(scene, 0.0); });
  CHECK(document.undoStack().count() == 0);
  CHECK_FALSE(document.isModified());
}

TEST_CASE("A drag is one step, and none when it ends where it began") {
  ui::Document document;
  document.reset(sceneWithParts(1), {});
  for (const double height : {1.0, 2.0, 3.0})
    document.edit(
        "Move", [&](Scene& scene) { moveFirst(scene, height); }, "drag");
  document.endGesture();
  CHECK(document.undoStack().count() == 1);
  document.edit(
      "Move", [](Scene& scene) { moveFirst(scene, 5.0); }, "drag");
  CHECK(document.undoStack().count() == 2);
  document.edit(
      "Move", [](Scene& scene) { moveFirst(scene, 3.0); }, "drag");
  CHECK(document.undoStack().count() == 1);
  document.undoStack().undo();
  CHECK(document.scene() == sceneWithParts(1));
}

TEST_CASE("Two drags of the same kind are two steps") {
  ui::Document document;
  document.reset(sceneWithParts(1), {});
  for (const double height : {1.0, 2.0}) {
    document.edit(
        "Move", [&](Scene& scene) { moveFirst(scene, height); }, "drag");
    document.endGesture();
  }
  CHECK(document.undoStack().count() == 2);
}

TEST_CASE("The selection forgets what undo takes away") {
  ui::Document document;
  ui::Selection selection(document);
  document.reset(sceneWithParts(1), {});
  document.edit("Add", [](Scene& scene) { scene = sceneWithParts(2); });
  selection.select({ui::ItemKind::part, 1});
  REQUIRE(selection.items().size() == 1);
  document.undoStack().undo();
  CHECK(selection.items().empty());
  CHECK(selection.current().kind == ui::ItemKind::scene);
}

}  // namespace
