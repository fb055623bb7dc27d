#include "ui/panels/live_panel.h"

#include <QSlider>
#include <QTest>
#include <QToolButton>

#include <catch2/catch.hpp>

#include "tests/ui/window_scenes.h"
#include "ui/timeline/play_actions.h"
#include "ui/viewport/viewport.h"

namespace {

using modeling::Scene;
using sim::TrackTarget;

struct LiveFixture : tests::SessionFixture {
  ui::PlayActions actions{session};
  ui::Viewport viewport{session};
  ui::LivePanel panel{session, viewport, actions};

  explicit LiveFixture(const Scene& scene) {
    load(scene);
    // Else a run of so few nodes is over before anyone can do something to it.
    session.setPace({1.0});
    panel.resize(300, 600);
    panel.show();
    REQUIRE(QTest::qWaitForWindowExposed(&panel));
  }

  void click(const char* button) { QTest::mouseClick(panel.findChild<QToolButton*>(button), Qt::LeftButton); }
  void finish() {
    REQUIRE(tests::becomesTrue([&] { return session.run()->phase == ui::RunPhase::done; }));
  }
};

Scene longSlab() {
  Scene scene = tests::fallingSlab();
  scene.output = {100.0, 0.4};
  return scene;
}

TEST_CASE("A sneeze that was performed becomes keys, and replays to the same bits") {
  LiveFixture fixture(longSlab());
  fixture.session.simulate();
  REQUIRE(tests::becomesTrue([&] { return fixture.session.run()->footage != nullptr; }));
  fixture.click("sneeze");
  fixture.finish();
  const Scene& scene = fixture.session.document().scene();
  REQUIRE(scene.tracks.size() == 1);
  const modeling::SceneTrack& track = scene.tracks[0];
  CHECK(track.target.target == TrackTarget::stiffnessScale);
  REQUIRE(track.keys.size() == 3);
  CHECK(std::get<double>(track.keys[1].value) == Approx(0.01));
  CHECK(std::get<double>(track.keys[2].value) == Approx(1.0));
  CHECK(track.keys[2].time - track.keys[1].time == Approx(0.1));
  REQUIRE(fixture.session.takes().size() == 1);
  CHECK_FALSE(fixture.session.takes()[0].stale);
  CHECK(tests::hashOfHeadlessRun(scene) == fixture.session.run()->stateHash);
  // It is one step of the history.
  fixture.session.document().undoStack().undo();
  CHECK(fixture.session.document().scene() == longSlab());
}

TEST_CASE("A knock is a collider that comes and goes, and replays to the same bits") {
  LiveFixture fixture(longSlab());
  fixture.session.simulate();
  REQUIRE(tests::becomesTrue([&] { return fixture.session.run()->footage != nullptr; }));
  fixture.panel.touchNow(ui::TouchTool::Kind::knock, sim::Vec3(1.5, 1.5, 1.5), sim::Vec3(1.0, 0.0, 0.0));
  fixture.finish();
  const Scene& scene = fixture.session.document().scene();
  REQUIRE(scene.environment.colliders.size() == 2);
  CHECK_FALSE(scene.environment.colliders[1].visible);
  CHECK(tests::hashOfHeadlessRun(scene) == fixture.session.run()->stateHash);
  CHECK(tests::hashOfHeadlessRun(scene) != tests::hashOfHeadlessRun(longSlab()));
}

TEST_CASE("Without a run a hiccup begins one") {
  LiveFixture fixture(longSlab());
  fixture.click("hiccup");
  CHECK(fixture.session.hasRun());
  fixture.finish();
  const Scene& scene = fixture.session.document().scene();
  REQUIRE(scene.tracks.size() == 1);
  CHECK(scene.tracks[0].target.target == TrackTarget::gravityScale);
  CHECK(tests::hashOfHeadlessRun(scene) == fixture.session.run()->stateHash);
}

TEST_CASE("What is performed with Record off leaves the scene alone") {
  LiveFixture fixture(longSlab());
  fixture.actions.record->trigger();
  fixture.click("sneeze");
  fixture.finish();
  CHECK(fixture.session.document().scene() == longSlab());
  CHECK(fixture.session.takes()[0].stale);
}

TEST_CASE("Without a run a slider edits the scene, a drag as one step") {
  LiveFixture fixture(tests::fallingSlab());
  ui::Document& document = fixture.session.document();
  auto* slider = fixture.panel.findChild<QWidget*>("stiffness")->findChild<QSlider*>();
  slider->setSliderDown(true);
  for (const int place : {700, 500, 300}) {
    slider->setValue(place);
    QTest::qWait(50);
  }
  slider->setSliderDown(false);
  REQUIRE(document.scene().tracks.size() == 1);
  CHECK(std::get<double>(document.scene().tracks[0].keys[0].value) == Approx(1e-3 * std::pow(1e4, 0.3)));
  CHECK(document.undoStack().count() == 1);
  document.undoStack().undo();
  CHECK(document.scene() == tests::fallingSlab());
}

}  // namespace
