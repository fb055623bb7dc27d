// The way of a person who opens the program for the first time, in the real window.
#include <QAbstractButton>
#include <QDockWidget>
#include <QPushButton>
#include <QTest>
#include <QToolButton>

#include <catch2/catch.hpp>

#include "modeling/scene/scene_file.h"
#include "tests/ui/whole_window.h"
#include "tests/ui/window_scenes.h"
#include "ui/files/autosave.h"
#include "ui/panels/add_actions.h"
#include "ui/theme/theme.h"
#include "ui/viewport/viewport.h"
#include "ui/window/main_window.h"

namespace {

namespace fs = std::filesystem;
using modeling::Scene;

struct Desk : tests::WholeWindow {
  QUndoStack& history() { return session.document().undoStack(); }
  void click(const char* button) {
    auto* found = window.findChild<QAbstractButton*>(QString::fromLatin1(button));
    REQUIRE(found != nullptr);
    QTest::mouseClick(found, Qt::LeftButton);
  }
  void raise(const char* dock) {
    WholeWindow::raise(dock);
    QTest::qWait(50);
  }
  bool isDone() { return session.run()->phase == ui::RunPhase::done; }
  void waitUntilBuilt() {
    REQUIRE(tests::becomesTrue([&] {
      return !session.isBuilding() && session.preview()->scene == scene() && session.preview()->built;
    }));
  }
};

TEST_CASE("A cup with a handle is built, dropped, broken, scrubbed, made to sneeze, undone and saved") {
  Desk desk;
  ui::Session& session = desk.session;
  desk.click("galleryNew");
  CHECK(desk.window.viewport().isVisible());
  const Scene empty = desk.scene();
  REQUIRE(empty.parts.empty());

  desk.click("add-cup");
  REQUIRE(desk.scene().parts.size() == 1);
  desk.waitUntilBuilt();
  desk.window.viewport().frameAll();
  desk.window.findChild<ui::AddActions*>()->add(ui::newThing("handle"));
  REQUIRE(desk.scene().parts.size() == 2);
  REQUIRE(desk.scene().glue.size() == 1);
  desk.waitUntilBuilt();
  session.document().edit("Throw it down", [](Scene& scene) {
    for (modeling::Part& part : scene.parts) {
      part.worldFromPart.position.z() += 2.0;
      part.velocity.z() = -600.0;
    }
    scene.output = {500.0, 0.03};
  });
  desk.waitUntilBuilt();
  CHECK(session.preview()->built->glue[0].nodesMerged > 0);

  desk.raise("live");
  // Slow until the sneeze is in, so that the run does not end before it on a busy machine.
  session.setPace({0.005});
  QTest::keyClick(&desk.window.viewport(), Qt::Key_Space);
  REQUIRE(
      tests::becomesTrue([&] { return session.run()->footage && session.run()->footage->frameCount() > 1; }));
  desk.click("sneeze");
  session.setPace({});
  REQUIRE(tests::becomesTrue([&] { return desk.isDone(); }));
  REQUIRE(session.takes().size() == 1);
  CHECK(session.run()->brokenBonds > 0);
  REQUIRE(desk.scene().tracks.size() == 1);
  CHECK_FALSE(session.takes()[0].stale);
  CHECK(tests::hashOfHeadlessRun(desk.scene()) == session.run()->stateHash);

  session.playback().toLast();
  desk.raise("takes");
  session.playback().toFirstBreak();
  const std::size_t first = session.playback().frame();
  REQUIRE(tests::becomesTrue([&] { return session.shown().moment->time == session.playback().time(); }));
  session.playback().stepBy(-1);
  CHECK(session.playback().frame() + 1 == first);
  REQUIRE(tests::becomesTrue([&] { return session.shown().moment->time == session.playback().time(); }));
  CHECK(session.shown().moment->broken->lostBonds() == 0);

  const Scene last = desk.scene();
  while (desk.history().canUndo()) desk.history().undo();
  CHECK(desk.scene() == empty);
  while (desk.history().canRedo()) desk.history().redo();
  CHECK(desk.scene() == last);

  ui::Theme::instance().apply(ui::ThemeKind::light);
  desk.raise("outliner");
  desk.raise("properties");
  ui::Theme::instance().apply(ui::ThemeKind::dark);
  const fs::path file = desk.root / "cup.scene.json";
  REQUIRE(session.document().saveTo(file));
  const auto loaded = modeling::loadScene(file);
  REQUIRE(loaded);
  CHECK(loaded->scene == last);
  CHECK_FALSE(desk.window.isWindowModified());
}

}  // namespace
