// What is done by hand in the real window, and reached without a mouse.
#include <QAction>
#include <QDockWidget>
#include <QDropEvent>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QTest>
#include <QTimer>
#include <set>

#include <catch2/catch.hpp>

#include "modeling/scene/scene_file.h"
#include "tests/ui/whole_window.h"
#include "tests/ui/window_scenes.h"
#include "ui/document/new_scene.h"
#include "ui/editors/glue_pairs.h"
#include "ui/files/autosave.h"
#include "ui/files/recent_files.h"
#include "ui/kinds/new_things.h"
#include "ui/viewport/viewport.h"
#include "ui/window/focus_order.h"
#include "ui/window/main_window.h"

namespace {

namespace fs = std::filesystem;
using modeling::Scene;
using tests::becomesTrue;

struct Desk : tests::WholeWindow {
  void load(const Scene& loaded) {
    session.document().reset(loaded, {});
    window.showViewport();
    REQUIRE(becomesTrue([&] {
      return !session.isBuilding() && session.preview()->scene == loaded && viewport().isUpToDate();
    }));
  }
  QAction& action(const char* text) {
    for (QAction* found : window.findChildren<QAction*>())
      if (found->text().remove(u'&').remove(QStringLiteral("…")) == QLatin1String(text)) return *found;
    FAIL("there is no action " << text);
    return *window.findChild<QAction*>();
  }
  void finish() {
    REQUIRE(becomesTrue([&] { return session.run()->phase == ui::RunPhase::done; }));
  }
};

/// Rubber that falls for long enough that something can be done to it.
Scene longFall() {
  Scene scene = tests::fallingSlab();
  scene.output = {100.0, 0.4};
  return scene;
}

sim::Vec3 middleOf(const ui::Shown& shown) {
  Eigen::AlignedBox3d box;
  for (const sim::Vec3& position : shown.moment->positions) box.extend(position);
  return box.center();
}

void touchByClick(Qt::Key key, const char* name) {
  Desk desk;
  desk.load(longFall());
  desk.raise("live");
  desk.session.setPace({0.02});
  desk.session.simulate();
  REQUIRE(becomesTrue([&] { return desk.session.run()->footage && desk.session.shown().live; }));
  QTest::keyClick(&desk.viewport(), key, Qt::ShiftModifier);
  REQUIRE(desk.viewport().tool() != nullptr);
  const std::optional<QPointF> at = desk.viewport().project(middleOf(desk.session.shown()));
  REQUIRE(at);
  QTest::mouseClick(&desk.viewport(), Qt::LeftButton, {}, at->toPoint());
  // It acts at once: the scene has it while the run goes on.
  REQUIRE(becomesTrue([&] { return desk.scene().environment.colliders.size() == 2; }));
  CHECK(desk.session.hasRun());
  CHECK(desk.scene().environment.colliders[1].name.starts_with(name));
  desk.session.setPace({});
  desk.finish();
  CHECK_FALSE(desk.session.takes()[0].stale);
  CHECK(tests::hashOfHeadlessRun(desk.scene()) == desk.session.run()->stateHash);
  CHECK(tests::hashOfHeadlessRun(longFall()) != desk.session.run()->stateHash);
  desk.session.document().undoStack().undo();
  CHECK(desk.scene() == longFall());
}

TEST_CASE("A poke where one clicks acts while it runs, and replays to the same bits") {
  touchByClick(Qt::Key_P, "poke");
}

TEST_CASE("A knock where one clicks acts while it runs, and replays to the same bits") {
  touchByClick(Qt::Key_K, "knock");
}

TEST_CASE("From any frame a take is continued with changed values, as a new take beside the old") {
  Desk desk;
  desk.load(tests::fallingSlab());
  CHECK_FALSE(desk.action("Continue with the Scene as It Is Now").isEnabled());
  desk.session.simulate();
  desk.finish();
  desk.session.playback().seek(4);
  desk.session.document().edit("Gravity", [](Scene& scene) { scene.environment.gravity.z() = -5000.0; });
  desk.session.playback().seek(4);
  REQUIRE(becomesTrue([&] { return desk.session.shown().recorded; }));
  desk.action("Continue with the Scene as It Is Now").trigger();
  REQUIRE(becomesTrue([&] { return desk.session.takes().size() == 2; }));
  desk.finish();
  const auto& takes = desk.session.takes();
  CHECK(desk.session.takes().current() == 1);
  REQUIRE(takes[1].continuedAt);
  CHECK(*takes[1].continuedAt == Approx(takes[0].footage->note(4).time));
  CHECK(takes[0].footage->frameCount() == 11);
  CHECK(takes[1].footage->frameCount() == 11);
}

/// Drops the file on the window and answers the question it asks.
void drop(Desk& desk, const fs::path& file, const char* answer) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(QString::fromStdString(file.string()))});
  QDragEnterEvent enter(QPoint(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&desk.window, &enter);
  CHECK(enter.isAccepted());
  // The question has an event loop of its own.
  bool answered = false;
  QTimer looks;
  QObject::connect(&looks, &QTimer::timeout, [&] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (box == nullptr || !box->isVisible()) return;
    for (QAbstractButton* button : box->buttons()) {
      if (button->text().remove(u'&') != QLatin1String(answer)) continue;
      answered = true;
      button->click();
    }
  });
  looks.start(10);
  QDropEvent dropped(QPointF(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&desk.window, &dropped);
  REQUIRE(becomesTrue([&] { return answered; }));
}

TEST_CASE("A mesh that is dropped on the window becomes a part or an obstacle, as one step") {
  Desk desk;
  desk.load(ui::newScene());
  const Scene before = desk.scene();
  const fs::path mesh = fs::path(SMITHEREENS_SOURCE_DIR) / "resources/scenes/meshes/fluted-vase.obj";
  drop(desk, mesh, "Obstacle");
  REQUIRE(desk.scene().environment.colliders.size() == 2);
  CHECK(std::holds_alternative<modeling::MeshObstacle>(desk.scene().environment.colliders[1].form));
  drop(desk, mesh, "Part");
  REQUIRE(desk.scene().parts.size() == 1);
  CHECK(std::holds_alternative<modeling::MeshShape>(desk.scene().parts[0].shape));
  REQUIRE(becomesTrue(
      [&] { return !desk.session.isBuilding() && desk.session.preview()->scene == desk.scene(); }));
  CHECK(desk.session.preview()->built);
  desk.session.document().undoStack().undo();
  desk.session.document().undoStack().undo();
  CHECK(desk.scene() == before);
}

TEST_CASE("The view of glue shows the pairs of all gluings while the scene is at rest") {
  Desk desk;
  Scene scene = ui::newScene();
  const ui::Item cup = ui::addThing(scene, ui::newThing("cup"), {});
  ui::addThing(scene, ui::newThing("handle"), {cup});
  ui::addThing(scene, ui::newThing("spout"), {cup});
  scene.output = {100.0, 0.01};
  desk.load(scene);
  auto& pairs = *desk.viewport().findChild<ui::GluePairs*>();
  CHECK(pairs.links().empty());
  ui::ViewSettings settings = desk.viewport().viewSettings();
  settings.gluePairs = true;
  desk.viewport().setViewSettings(settings);
  const auto glued = desk.session.preview()->built->glue;
  REQUIRE(glued.size() == 2);
  const std::size_t wanted = glued[0].nodesMerged + glued[1].nodesMerged;
  REQUIRE(becomesTrue([&] { return pairs.links().size() == wanted; }));
  desk.session.document().edit("Unglue", [](Scene& edited) { edited.glue.pop_back(); });
  REQUIRE(becomesTrue([&] { return pairs.links().size() == glued[0].nodesMerged; }));
  desk.session.simulate();
  REQUIRE(becomesTrue([&] { return pairs.links().empty(); }));
  desk.finish();
}

TEST_CASE("A scene that was left has a picture among the recent ones") {
  Desk desk;
  const fs::path file = desk.root / "slab.scene.json";
  REQUIRE(modeling::saveScene(tests::fallingSlab(), file));
  desk.window.files().open(file);
  REQUIRE(becomesTrue([&] { return desk.viewport().isUpToDate() && desk.session.shown().moment; }));
  desk.window.showGallery();
  const ui::RecentFiles recent;
  REQUIRE_FALSE(recent.files().empty());
  CHECK(fs::equivalent(recent.files().front(), file));
  CHECK_FALSE(recent.picture(file).isNull());
}

/// Presses Tab from the first thing in the panel until the focus leaves it or comes round. Lines are read
/// from above, each from the left.
void checkTabs(QWidget& panel, QWidget& first, const char* name) {
  first.setFocus(Qt::TabFocusReason);
  REQUIRE(becomesTrue([&] { return first.isAncestorOf(QApplication::focusWidget()) || first.hasFocus(); }));
  std::set<QWidget*> passed;
  QWidget* at = QApplication::focusWidget();
  while (passed.insert(at).second) {
    QTest::keyClick(at, Qt::Key_Tab);
    QWidget* next = QApplication::focusWidget();
    if (!panel.isAncestorOf(next) || passed.contains(next)) break;
    const QRect before(at->mapTo(&panel, QPoint()), at->size());
    const QRect after(next->mapTo(&panel, QPoint()), next->size());
    INFO(name << ": from " << at->objectName().toStdString() << " to " << next->metaObject()->className()
              << " " << next->objectName().toStdString());
    const bool below = after.center().y() > before.bottom();
    const bool right = after.left() >= before.right() && after.bottom() > before.top();
    CHECK((below || right));
    at = next;
  }
  CHECK(passed.size() > 1);
}

Scene cupWithHandle() {
  Scene scene = tests::breakingSlab();
  ui::addThing(scene, ui::newThing("cup"), {});
  ui::addThing(scene, ui::newThing("handle"), {{ui::ItemKind::part, 1}});
  return scene;
}

TEST_CASE("Tab goes through panels as one reads, and F6 from one to the next") {
  Desk desk;
  const Scene scene = cupWithHandle();
  desk.load(scene);
  desk.session.selection().select({ui::ItemKind::part, 1});
  for (const char* name : {"outliner", "live", "timeline", "profile"}) {
    desk.raise(name);
    QWidget& dock = *desk.window.findChild<QDockWidget*>(QString::fromLatin1(name));
    INFO(name);
    REQUIRE(becomesTrue([&] { return !ui::readingOrder(dock).empty(); }));
    checkTabs(dock, *ui::readingOrder(dock).front(), name);
  }
  desk.raise("properties");
  QWidget& properties = *desk.window.findChild<QDockWidget*>("properties");
  for (const ui::ItemKind kind : {ui::ItemKind::scene, ui::ItemKind::part, ui::ItemKind::gluing,
                                  ui::ItemKind::collider, ui::ItemKind::material}) {
    desk.session.selection().select({kind, ui::countOf(scene, kind) - 1});
    QApplication::processEvents();  // the form is laid out
    REQUIRE_FALSE(ui::readingOrder(properties).empty());
    checkTabs(properties, *ui::readingOrder(properties).front(), "properties");
  }
  const std::size_t places = ui::placesOf(desk.window).size();
  CHECK(places > 4);
  desk.viewport().setFocus();
  std::set<const QWidget*> seen;
  for (std::size_t press = 0; press < places; ++press) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F6);
    seen.insert(QApplication::focusWidget());
  }
  CHECK(seen.size() == places);
  CHECK(desk.viewport().hasFocus());
}

TEST_CASE("Tab goes through dialogs as one reads") {
  Desk desk;
  desk.load(cupWithHandle());
  const std::pair<const char*, const char*> dialogs[] = {{"Render", "render-what"},
                                                         {"Tune Threshold", "threshold-material"}};
  for (const auto& [opens, first] : dialogs) {
    desk.action(opens).trigger();
    auto* widget = desk.window.findChild<QWidget*>(QString::fromLatin1(first));
    REQUIRE(widget != nullptr);
    QWidget* dialog = widget->window();
    dialog->activateWindow();
    REQUIRE(QTest::qWaitForWindowActive(dialog));
    checkTabs(*dialog, *widget, opens);
    dialog->close();
    desk.window.activateWindow();
  }
}

}  // namespace
