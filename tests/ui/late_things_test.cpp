// What comes late, fails or is said must not change what the person chose to see.
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QTest>

#include <catch2/catch.hpp>

#include "modeling/scene/tracks.h"
#include "tests/ui/whole_window.h"
#include "tests/ui/window_scenes.h"
#include "ui/document/new_scene.h"
#include "ui/editors/glue_pairs.h"
#include "ui/kinds/new_things.h"
#include "ui/panels/outliner_tree.h"
#include "ui/theme/theme.h"
#include "ui/timeline/time_bar.h"
#include "ui/timeline/transport.h"
#include "ui/viewport/viewport.h"

namespace {

using modeling::Scene;
using tests::becomesTrue;

struct Desk : tests::WholeWindow {
  void load(const Scene& loaded) {
    session.document().reset(loaded, {});
    window.showViewport();
    settle();
  }
  void settle() {
    REQUIRE(becomesTrue([&] { return !session.isBuilding() && viewport().isUpToDate(); }));
  }
  void simulate() {
    session.simulate();
    REQUIRE(becomesTrue([&] { return session.run()->phase == ui::RunPhase::done; }));
  }
};

TEST_CASE("A frame that was chosen after an edit stays, however late the scene is built") {
  Desk desk;
  desk.load(tests::fallingSlab());
  desk.simulate();
  desk.session.document().edit("Larger",
                               [](Scene& scene) { scene.parts[0].worldFromPart.position.z() = 9.0; });
  // The build cannot have come yet: nobody looked.
  desk.session.playback().seek(4);
  desk.settle();
  CHECK(desk.session.shown().recorded);
  CHECK(desk.session.shown().moment->time == desk.session.takes()[0].footage->note(4).time);
  // Without a choice the edit is what one wants to see.
  desk.session.document().edit("Larger",
                               [](Scene& scene) { scene.parts[0].worldFromPart.position.z() = 8.0; });
  desk.settle();
  CHECK_FALSE(desk.session.shown().recorded);
}

Scene cupAndFarHandle() {
  Scene scene = ui::newScene();
  const ui::Item cup = ui::addThing(scene, ui::newThing("cup"), {});
  ui::addThing(scene, ui::newThing("handle"), {cup});
  scene.parts[1].worldFromPart.position.x() += 30.0;
  return scene;
}

TEST_CASE("Parts whose glue fails are drawn unglued, and the glue in red") {
  Desk desk;
  desk.load(cupAndFarHandle());
  const ui::Preview& preview = *desk.session.preview();
  REQUIRE(preview.problem);
  CHECK_FALSE(preview.built);
  REQUIRE(desk.session.shown().network);
  CHECK(desk.session.shown().network->partNames.size() == 2);
  CHECK(preview.scene.glue == desk.scene().glue);
  auto& pairs = *desk.viewport().findChild<ui::GluePairs*>();
  CHECK(becomesTrue([&] { return pairs.failed().size() == 1; }));
  auto& tree = *desk.window.findChild<ui::OutlinerTree*>();
  const QTreeWidgetItem& row = *tree.rowOf({ui::ItemKind::gluing, 0});
  CHECK(row.foreground(0).color() == ui::Theme::instance().colours().bad);
  CHECK_FALSE(row.toolTip(0).isEmpty());
  // It is not simulated as if it were whole.
  desk.session.simulate();
  CHECK(becomesTrue([&] { return desk.session.run()->phase == ui::RunPhase::failed; }));
  desk.session.document().edit("Back",
                               [](Scene& scene) { scene.parts[1].worldFromPart.position.x() -= 30.0; });
  desk.settle();
  CHECK(desk.session.preview()->built);
  CHECK(becomesTrue([&] { return pairs.failed().empty(); }));
  CHECK(row.foreground(0).color() != ui::Theme::instance().colours().bad);
}

TEST_CASE("Of several gluings only those that fail are left out") {
  Desk desk;
  Scene scene = cupAndFarHandle();
  ui::addThing(scene, ui::newThing("spout"), {{ui::ItemKind::part, 0}});
  REQUIRE(scene.glue.size() == 2);
  desk.load(scene);
  REQUIRE(desk.session.preview()->failedGluings.size() == 1);
  CHECK(desk.session.preview()->failedGluings[0].gluing == 0);
  CHECK(desk.session.preview()->unglued->glue.size() == 1);
}

bool seesAll(Desk& desk) {
  const auto& drawn = *desk.viewport().drawn();
  return !drawn.box.isEmpty() && desk.viewport().camera().sees(drawn.box, desk.viewport().viewSize());
}

TEST_CASE("Scenes that are opened or new are framed") {
  Desk desk;
  Scene small = tests::fallingSlab();
  Scene large = small;
  std::get<modeling::SlabShape>(large.parts[0].shape) =
      modeling::SlabShape{sim::Vec3(300.0, 300.0, 100.0), {50.0, {}}};
  desk.load(small);
  REQUIRE(becomesTrue([&] { return seesAll(desk); }));
  const double near = desk.viewport().camera().distance();
  desk.load(large);
  CHECK(becomesTrue([&] { return seesAll(desk); }));
  CHECK(desk.viewport().camera().distance() > 10.0 * near);
  desk.load(small);
  CHECK(becomesTrue([&] { return seesAll(desk) && desk.viewport().camera().distance() < 2.0 * near; }));
  // A new scene is, once something stands in it.
  desk.load(large);
  desk.load(ui::newScene());
  desk.session.document().edit("Add", [](Scene& scene) { ui::addThing(scene, ui::newThing("cup"), {}); });
  desk.settle();
  CHECK(becomesTrue([&] { return seesAll(desk) && desk.viewport().camera().distance() < 200.0; }));
}

TEST_CASE("The transport stays where it is, whatever happens and is said") {
  Desk desk;
  Scene scene = tests::fallingSlab();
  scene.output = {1000.0, 0.5};
  desk.load(scene);
  auto& transport = *desk.window.findChild<ui::Transport*>();
  const auto places = [&] {
    // Docks are laid out in the next turns of the event loop.
    QTest::qWait(300);
    std::vector<QRect> found{QRect(transport.mapTo(&desk.window, QPoint()), transport.size())};
    for (const QWidget* child : transport.findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly))
      if (child->isVisible()) found.push_back({child->mapTo(&desk.window, QPoint()), child->size()});
    return found;
  };
  QTest::qWait(100);
  const std::vector<QRect> before = places();
  const QRect bar = before.front();
  const auto fieldsStay = [&](const std::vector<QRect>& after) {
    CHECK(after.front() == bar);
    for (const QRect& place : before) CHECK(std::ranges::find(after, place) != after.end());
  };
  desk.session.setPace({0.5});
  desk.session.simulate();
  REQUIRE(becomesTrue([&] { return desk.session.shown().live; }));
  fieldsStay(places());
  desk.session.pauseRun(true);
  REQUIRE(becomesTrue([&] { return desk.session.run()->phase == ui::RunPhase::paused; }));
  fieldsStay(places());
  desk.session.document().edit(
      "Add Track", [](Scene& edited) { modeling::addTrack(edited, modeling::targetsOf(edited).front()); });
  fieldsStay(places());
  desk.session.setPace({});
  desk.session.pauseRun(false);
  REQUIRE(becomesTrue([&] { return desk.session.run()->phase == ui::RunPhase::done; }));
  fieldsStay(places());
}

TEST_CASE("A take that nobody looks at keeps no frames, and is there again when it is chosen") {
  Desk desk;
  desk.load(tests::fallingSlab());
  desk.simulate();
  const std::shared_ptr<ui::Footage> first = desk.session.takes()[0].footage;
  CHECK(first->held(3));
  desk.simulate();
  REQUIRE(desk.session.takes().size() == 2);
  CHECK_FALSE(first->held(3));
  CHECK(first->frameCount() == 11);
  desk.session.takes().select(0);
  desk.session.playback().seek(3);
  CHECK(becomesTrue([&] {
    return desk.session.shown().recorded && desk.session.shown().moment->time == first->note(3).time;
  }));
  REQUIRE(desk.session.shown().network);
  CHECK(desk.session.shown().network->nodeCount() == desk.session.takes()[1].footage->network()->nodeCount());
}

}  // namespace
