#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <fstream>

#include <catch2/catch.hpp>
#include <sys/resource.h>

#include "modeling/scene/scene_file.h"
#include "tests/ui/left_behind.h"
#include "tests/ui/window_scenes.h"
#include "ui/document/new_scene.h"
#include "ui/files/autosave.h"
#include "ui/files/leftovers.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

namespace {

namespace fs = std::filesystem;

using tests::answer;
using tests::leaveBehind;

fs::path pathOf(const QTemporaryDir& folder) {
  return folder.path().toStdString();
}

void addSlab(modeling::Scene& scene) {
  modeling::Part part;
  part.name = "slab";
  part.material = scene.materials.front().name;
  part.shape = modeling::SlabShape{sim::Vec3(3.0, 3.0, 1.0), {1.0, {}}};
  scene.parts.push_back(part);
}

TEST_CASE("What was not saved when the program was killed can be recovered") {
  const QTemporaryDir place;
  const fs::path root = pathOf(place);
  modeling::Scene edited;
  fs::path left;
  {
    const fs::path folder = ui::Autosave::newFolder(root);
    ui::Session session(folder);
    ui::Autosave autosave(session, folder);
    session.document().reset(ui::newScene(), {});
    session.document().edit("Add", addSlab);
    autosave.write();
    edited = session.document().scene();
    CHECK(ui::leftoversIn(root).empty());
    left = leaveBehind(folder, root);
  }
  const std::vector<ui::Leftover> leftovers = ui::leftoversIn(root);
  REQUIRE(leftovers.size() == 1);
  CHECK(leftovers[0].scene == edited);
  ui::discard(leftovers[0]);
  CHECK_FALSE(fs::exists(left));
  CHECK(ui::leftoversIn(root).empty());
}

TEST_CASE("A program that ends well leaves nothing behind") {
  const QTemporaryDir place;
  {
    const fs::path folder = ui::Autosave::newFolder(pathOf(place));
    ui::Session session(folder);
    ui::Autosave autosave(session, folder);
    session.document().reset(ui::newScene(), {});
    session.document().edit("Add", addSlab);
    autosave.write();
  }
  CHECK(fs::is_empty(pathOf(place)));
}

TEST_CASE("The window opens a scene, asks before it gives up changes, and saves them whole") {
  const QTemporaryDir place;
  const fs::path file = pathOf(place) / "slab.scene.json";
  modeling::Scene scene = ui::newScene();
  addSlab(scene);
  REQUIRE(modeling::saveScene(scene, file));
  ui::Session session(pathOf(place) / "takes");
  ui::MainWindow window(session);
  window.show();
  REQUIRE(QTest::qWaitForWindowExposed(&window));
  window.files().open(file);
  CHECK(session.document().scene() == scene);
  CHECK(window.viewport().isVisible());
  CHECK_FALSE(window.isWindowModified());

  session.document().edit(
      "Move", [](modeling::Scene& changed) { changed.parts[0].worldFromPart.position.z() = 5.0; });
  CHECK(window.isWindowModified());
  answer("Cancel");
  CHECK_FALSE(window.files().mayLeave());
  answer("Discard");
  CHECK(window.files().mayLeave());
  answer("Save");
  CHECK(window.files().mayLeave());
  CHECK_FALSE(window.isWindowModified());
  const auto saved = modeling::loadScene(file);
  REQUIRE(saved);
  CHECK(saved->scene == session.document().scene());
  // The history survives saving.
  session.document().undoStack().undo();
  CHECK(session.document().scene() == scene);
  CHECK(window.isWindowModified());
  session.document().undoStack().redo();
}

/// A run of a small scene to its end, in a session that keeps its takes in `folder`.
void makeTake(ui::Session& session) {
  session.document().reset(tests::fallingSlab(), {});
  session.simulate();
  REQUIRE(tests::becomesTrue([&] { return session.run()->phase == ui::RunPhase::done; }));
}

TEST_CASE("Takes of a killed program come back with their names, even where no scene was written aside") {
  const QTemporaryDir place;
  const fs::path root = pathOf(place);
  {
    const fs::path folder = ui::Autosave::newFolder(root);
    ui::Session session(folder);
    ui::Autosave autosave(session, folder);
    makeTake(session);
    session.takes().rename(0, "the good one");
    autosave.write();
    leaveBehind(folder, root);
  }
  const bool sceneIsThere = GENERATE(true, false);
  if (!sceneIsThere) fs::remove(root / "left-behind" / "autosave.scene.json");
  const std::vector<ui::Leftover> leftovers = ui::leftoversIn(root);
  REQUIRE(leftovers.size() == 1);
  CHECK(leftovers[0].scene == tests::fallingSlab());
  ui::Session session(root / "next");
  session.document().reset(leftovers[0].scene, {});
  session.takes().adopt(leftovers[0].takes);
  REQUIRE(session.takes().size() == 1);
  CHECK(session.takes()[0].name == "the good one");
  CHECK(session.takes()[0].footage->frameCount() == 11);
  CHECK(session.takes()[0].own);
}

TEST_CASE("A run on a disk that is full waits and says so, and goes on when there is room") {
  ::signal(SIGXFSZ, SIG_IGN);
  tests::SessionFixture fixture;
  ui::Session& session = fixture.session;
  session.document().reset(tests::fallingSlab(), {});
  rlimit before{};
  REQUIRE(::getrlimit(RLIMIT_FSIZE, &before) == 0);
  rlimit full = before;
  full.rlim_cur = 6000;
  REQUIRE(::setrlimit(RLIMIT_FSIZE, &full) == 0);
  session.simulate();
  const bool waits = tests::becomesTrue([&] { return session.run()->problem.has_value(); });
  const bool paused = session.run()->phase == ui::RunPhase::paused;
  REQUIRE(::setrlimit(RLIMIT_FSIZE, &before) == 0);
  REQUIRE(waits);
  REQUIRE(paused);
  session.pauseRun(false);
  REQUIRE(tests::becomesTrue([&] { return session.run()->phase == ui::RunPhase::done; }));
  const auto reader = sim::TakeReader::open(session.takes()[0].footage->file());
  REQUIRE(reader);
  CHECK((*reader)->frameCount() >= 11);
  CHECK((*reader)->droppedBytes() == 0);
}

TEST_CASE("A file that is no scene is reported and changes nothing") {
  const QTemporaryDir place;
  const fs::path file = pathOf(place) / "broken.scene.json";
  std::ofstream(file) << R"({"smithereens": 1, "parts": [)";
  ui::Session session(pathOf(place) / "takes");
  ui::MainWindow window(session);
  window.show();
  REQUIRE(QTest::qWaitForWindowExposed(&window));
  window.showViewport();
  std::string said;
  QObject::connect(&session, &ui::Session::problemFound, &window,
                   [&](const sim::Problem& problem) { said = problem.line(); });
  const modeling::Scene before = session.document().scene();
  window.files().open(file);
  CHECK(said.find("broken.scene.json:1:") != std::string::npos);
  CHECK(session.document().scene() == before);
}

TEST_CASE("A scene with keys that mean nothing any more opens, and the person is told") {
  const QTemporaryDir place;
  const fs::path file = pathOf(place) / "old.scene.json";
  std::ofstream(file) << R"({"smithereens": 1, "materials": {"clay": {}},
 "parts": [{"name": "slab", "kind": "slab", "material": "clay", "size": [3, 3, 1]}],
 "solver": {"precision": "float", "skip": {"ledger": false}}})";
  ui::Session session(pathOf(place) / "takes");
  ui::MainWindow window(session);
  window.show();
  REQUIRE(QTest::qWaitForWindowExposed(&window));
  window.showViewport();
  std::string said;
  QObject::connect(&session, &ui::Session::problemFound, &window,
                   [&](const sim::Problem& problem) { said = problem.line(); });
  window.files().open(file);
  CHECK(session.document().scene().parts.size() == 1);
  CHECK(said.find("old.scene.json:3:") != std::string::npos);
  CHECK(said.find("\"precision\" means nothing since") != std::string::npos);
  CHECK(said.find("1 more such key") != std::string::npos);
}

}  // namespace
