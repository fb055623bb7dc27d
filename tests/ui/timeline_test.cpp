#include "ui/timeline/timeline.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QTest>
#include <QTimer>
#include <set>

#include <catch2/catch.hpp>

#include "tests/ui/window_scenes.h"
#include "ui/timeline/key_popup.h"
#include "ui/timeline/play_actions.h"
#include "ui/timeline/time_bar.h"
#include "ui/timeline/track_rows.h"

namespace {

using modeling::Scene;

/// A timeline in a window of its own.
struct TimelineFixture : tests::SessionFixture {
  ui::PlayActions actions{session};
  ui::Timeline timeline{session, actions};

  explicit TimelineFixture(const Scene& scene) {
    load(scene);
    timeline.addActions(actions.findChildren<QAction*>(Qt::FindDirectChildrenOnly));
    timeline.resize(900, 260);
    timeline.show();
    timeline.activateWindow();
    REQUIRE(QTest::qWaitForWindowExposed(&timeline));
  }

  ui::Playback& playback() { return session.playback(); }
  QPoint on(double time, int y) { return {qRound(timeline.bar().xOf(time)), y}; }
  QPoint onFilm(double time) { return on(time, ui::TimeBar::kRulerHeight + 10); }
  void drag(QWidget& widget, const QPoint& from, const QPoint& to) {
    QTest::mousePress(&widget, Qt::LeftButton, {}, from);
    for (int part = 1; part <= 4; ++part) QTest::mouseMove(&widget, from + (to - from) * part / 4);
    QTest::mouseRelease(&widget, Qt::LeftButton, {}, to);
  }
};

Scene sceneWithTrack() {
  Scene scene = tests::fallingSlab();
  modeling::SceneTrack track;
  track.target = {sim::TrackTarget::stiffnessScale, {}};
  track.keys = {{0.0, 1.0}, {0.05, 2.0}};
  scene.tracks.push_back(track);
  return scene;
}

TEST_CASE("Dragging along the take shows each frame that is passed") {
  TimelineFixture fixture(tests::fallingSlab());
  fixture.simulateToEnd();
  QTest::mousePress(&fixture.timeline.bar(), Qt::LeftButton, {}, fixture.onFilm(0.02));
  CHECK(fixture.playback().frame() == 2);
  for (const std::size_t frame : {std::size_t{3}, std::size_t{7}, std::size_t{5}}) {
    QTest::mouseMove(&fixture.timeline.bar(), fixture.onFilm(0.01 * static_cast<double>(frame)));
    REQUIRE(tests::becomesTrue([&] { return fixture.playback().frame() == frame; }));
    CHECK(fixture.session.shown().moment == fixture.playback().footage()->held(frame));
  }
  QTest::mouseRelease(&fixture.timeline.bar(), Qt::LeftButton, {}, fixture.onFilm(0.05));
  CHECK(fixture.timeline.findChild<QDoubleSpinBox*>("time")->value() ==
        Approx(fixture.playback().footage()->note(5).time).margin(1e-4));
}

TEST_CASE("The frame under the cursor can be shown again after the scene at rest") {
  TimelineFixture fixture(tests::fallingSlab());
  fixture.simulateToEnd();
  fixture.playback().seek(4);
  fixture.session.showEdited();
  CHECK_FALSE(fixture.session.shown().recorded);
  QTest::mouseClick(&fixture.timeline.bar(), Qt::LeftButton, {}, fixture.onFilm(0.04));
  CHECK(fixture.session.shown().recorded);
}

TEST_CASE("A range to loop is dragged above the ruler, by its ends moved, and cleared by a double click") {
  TimelineFixture fixture(tests::fallingSlab());
  fixture.simulateToEnd();
  ui::TimeBar& bar = fixture.timeline.bar();
  fixture.drag(bar, fixture.on(0.03, 5), fixture.on(0.07, 5));
  REQUIRE(fixture.playback().loopRange());
  const double pixel = fixture.timeline.axis().secondsPerPixel();
  CHECK(fixture.playback().loopRange()->from == Approx(0.03).margin(pixel));
  CHECK(fixture.playback().loopRange()->to == Approx(0.07).margin(pixel));
  CHECK(fixture.playback().loops());
  CHECK(fixture.actions.loop->isChecked());
  fixture.drag(bar, fixture.on(0.07, 5), fixture.on(0.09, 5));
  CHECK(fixture.playback().loopRange()->from == Approx(0.03).margin(pixel));
  CHECK(fixture.playback().loopRange()->to == Approx(0.09).margin(2 * pixel));
  QTest::mouseDClick(&bar, Qt::LeftButton, {}, fixture.on(0.05, 5));
  CHECK_FALSE(fixture.playback().loopRange());
}

TEST_CASE("The wheel zooms the time about the pointer") {
  TimelineFixture fixture(tests::fallingSlab());
  ui::TimeAxis& axis = fixture.timeline.axis();
  const double x = axis.xOf(0.05);
  axis.zoom(0.1, x);
  CHECK(axis.xOf(0.05) == Approx(x));
  CHECK_FALSE(axis.showsAll());
  CHECK(axis.to() - axis.from() < 0.02);
  axis.zoom(1000.0, x);
  CHECK(axis.showsAll());
}

TEST_CASE("Keys of the keyboard step, play and loop") {
  TimelineFixture fixture(tests::fallingSlab());
  fixture.simulateToEnd();
  QWidget& window = fixture.timeline;
  REQUIRE(QTest::qWaitForWindowActive(&window));
  fixture.playback().seek(4);
  QTest::keyClick(&window, Qt::Key_Right);
  CHECK(fixture.playback().frame() == 5);
  QTest::keyClick(&window, Qt::Key_Left);
  QTest::keyClick(&window, Qt::Key_Left);
  CHECK(fixture.playback().frame() == 3);
  QTest::keyClick(&window, Qt::Key_Right, Qt::ShiftModifier);
  CHECK(fixture.playback().frame() == 10);
  QTest::keyClick(&window, Qt::Key_Left, Qt::ShiftModifier);
  CHECK(fixture.playback().frame() == 0);
  QTest::keyClick(&window, Qt::Key_L);
  CHECK(fixture.playback().loops());
  QTest::keyClick(&window, Qt::Key_Space);
  CHECK(fixture.playback().direction() == 1);
  QTest::keyClick(&window, Qt::Key_Space);
  CHECK(fixture.playback().direction() == 0);
}

TEST_CASE("Breaks are marked by their number, and one leads to the first") {
  CHECK(ui::TimeBar::tickHeight(0, 1000) == 0.0);
  CHECK(ui::TimeBar::tickHeight(1, 1000) > 0.1);
  CHECK(ui::TimeBar::tickHeight(1, 1000) < ui::TimeBar::tickHeight(30, 1000));
  CHECK(ui::TimeBar::tickHeight(1000, 1000) == Approx(1.0));

  TimelineFixture fixture(tests::breakingSlab());
  CHECK_FALSE(fixture.actions.toFirstBreak->isEnabled());
  fixture.simulateToEnd();
  const std::optional<double> broke = fixture.playback().footage()->firstBreak();
  REQUIRE(broke);
  REQUIRE(fixture.actions.toFirstBreak->isEnabled());
  fixture.actions.toFirstBreak->trigger();
  const std::size_t frame = fixture.playback().frame();
  CHECK(fixture.playback().footage()->note(frame).brokenBonds > 0);
  CHECK(fixture.playback().footage()->note(frame - 1).brokenBonds == 0);
}

TEST_CASE("Simulate becomes Pause and Continue, and Stop keeps what is done") {
  Scene scene = tests::fallingSlab();
  scene.output.duration = 1000.0;
  TimelineFixture fixture(scene);
  ui::Session& session = fixture.session;
  CHECK(fixture.actions.simulate->text() == "Simulate");
  fixture.actions.simulate->trigger();
  CHECK(fixture.actions.simulate->text() == "Pause");
  REQUIRE(
      tests::becomesTrue([&] { return session.run()->footage && session.run()->footage->frameCount() > 2; }));
  fixture.actions.simulate->trigger();
  REQUIRE(tests::becomesTrue([&] { return session.run()->phase == ui::RunPhase::paused; }));
  CHECK(fixture.actions.simulate->text() == "Continue");
  fixture.actions.stop->trigger();
  REQUIRE(tests::becomesTrue([&] { return session.run()->phase == ui::RunPhase::done; }));
  CHECK(fixture.actions.simulate->text() == "Simulate");
  CHECK(session.takes().size() == 1);
  CHECK(session.takes()[0].footage->frameCount() > 2);
}

TEST_CASE("A key is dragged in time and value as one step of the history") {
  TimelineFixture fixture(sceneWithTrack());
  ui::TrackRows& rows = fixture.timeline.rows();
  {
    ui::Document& document = fixture.session.document();
    const Scene before = document.scene();
    rows.setExpanded(0, true);
    QTest::qWait(1);
    const QPoint from = rows.pointOf({0, 1}).toPoint();
    const QPoint to = from + QPoint(60, 30);
    fixture.drag(rows, from, to);
    const modeling::SceneTrackKey& moved = document.scene().tracks[0].keys[1];
    CHECK(moved.time == Approx(0.05 + 60 * fixture.timeline.axis().secondsPerPixel()).margin(1e-3));
    CHECK(std::get<double>(moved.value) < 2.0);
    const Scene after = document.scene();
    CHECK(document.undoStack().count() == 1);
    document.undoStack().undo();
    CHECK(document.scene() == before);
    document.undoStack().redo();
    CHECK(document.scene() == after);
  }
}

TEST_CASE("Keys are added by a double click and taken away by Delete") {
  TimelineFixture fixture(sceneWithTrack());
  ui::TrackRows& rows = fixture.timeline.rows();
  ui::Document& document = fixture.session.document();
  const Scene before = document.scene();
  const QPoint place(qRound(fixture.timeline.bar().xOf(0.025)), ui::TrackLayout::kRowHeight / 2);
  QTest::mouseDClick(&rows, Qt::LeftButton, {}, place);
  REQUIRE(document.scene().tracks[0].keys.size() == 3);
  // It lies on the curve: nothing moves otherwise.
  const modeling::SceneTrackKey added = document.scene().tracks[0].keys[1];
  CHECK(std::get<double>(added.value) == Approx(1.0 + added.time / 0.05));
  REQUIRE(rows.selectedKey());
  QTest::keyClick(&rows, Qt::Key_Delete);
  CHECK(document.scene() == before);
  document.undoStack().undo();
  document.undoStack().undo();
  CHECK(document.scene() == before);
}

TEST_CASE("A double click on a key types its time and value, as one step") {
  TimelineFixture fixture(sceneWithTrack());
  ui::TrackRows& rows = fixture.timeline.rows();
  ui::Document& document = fixture.session.document();
  const Scene before = document.scene();
  QTest::mouseDClick(&rows, Qt::LeftButton, {}, rows.pointOf({0, 1}).toPoint());
  auto* popup = rows.findChild<ui::KeyPopup*>();
  REQUIRE(popup != nullptr);
  const QList<QDoubleSpinBox*> fields = popup->findChildren<QDoubleSpinBox*>();
  REQUIRE(fields.size() == 2);
  fields[0]->setValue(0.07);
  fields[1]->setValue(3.5);
  QTest::keyClick(fields[1], Qt::Key_Return);
  CHECK_FALSE(popup->isVisible());
  const modeling::SceneTrackKey& typed = document.scene().tracks[0].keys[1];
  CHECK(typed.time == Approx(0.07));
  CHECK(std::get<double>(typed.value) == Approx(3.5));
  CHECK(document.undoStack().count() == 1);
  document.undoStack().undo();
  CHECK(document.scene() == before);
}

TEST_CASE("The menu of a track says what is between its keys") {
  TimelineFixture fixture(sceneWithTrack());
  ui::TrackRows& rows = fixture.timeline.rows();
  const std::pair<const char*, sim::Interpolation> choices[] = {{"Step", sim::Interpolation::step},
                                                                {"Smooth", sim::Interpolation::smooth},
                                                                {"Linear", sim::Interpolation::linear}};
  for (const auto& [word, interpolation] : choices) {
    QTimer looks;
    QObject::connect(&looks, &QTimer::timeout, [word = word] {
      auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
      if (menu == nullptr) return;
      for (QAction* action : menu->actions())
        if (action->text().startsWith(QLatin1String(word))) action->trigger();
      menu->close();
    });
    looks.start(5);
    const QPoint at(100, ui::TrackLayout::kRowHeight / 2);
    QContextMenuEvent asks(QContextMenuEvent::Mouse, at, rows.mapToGlobal(at));
    QApplication::sendEvent(&rows, &asks);
    CHECK(fixture.session.document().scene().tracks[0].interpolation == interpolation);
  }
  CHECK(fixture.session.document().undoStack().count() == 3);
}

/// Three tracks that drive different things, with keys at different times.
Scene sceneWithThreeTracks() {
  Scene scene = sceneWithTrack();
  for (const sim::TrackTarget target : {sim::TrackTarget::dampingScale, sim::TrackTarget::gravityScale}) {
    modeling::SceneTrack track;
    track.target = {target, {}};
    track.keys = {{0.0, 1.0}, {0.02, 1.5}, {0.05, 2.0}};
    scene.tracks.push_back(track);
  }
  return scene;
}

void removeTrack(ui::Document& document, std::size_t track) {
  document.edit("Remove", [track](Scene& scene) {
    scene.tracks.erase(scene.tracks.begin() + static_cast<std::ptrdiff_t>(track));
  });
}

TEST_CASE("A key that goes while the mouse holds it is let go") {
  TimelineFixture fixture(sceneWithThreeTracks());
  ui::TrackRows& rows = fixture.timeline.rows();
  ui::Document& document = fixture.session.document();
  const QPoint at = rows.pointOf({2, 2}).toPoint();
  QTest::mousePress(&rows, Qt::LeftButton, {}, at);
  QTest::mouseMove(&rows, at + QPoint(20, 0));
  REQUIRE(document.scene().tracks[2].keys[2].time > 0.05);
  SECTION("by the removal of its track") {
    removeTrack(document, 2);
  }
  SECTION("by an undo of all that made it") {
    document.edit("None", [](Scene& scene) { scene.tracks.clear(); });
  }
  SECTION("by the removal of another key of its track") {
    document.edit("Remove Key", [](Scene& scene) { modeling::removeKey(scene, 2, 0); });
  }
  SECTION("by another scene") {
    document.reset(sceneWithThreeTracks(), {});
  }
  const Scene left = document.scene();
  QTest::mouseMove(&rows, at + QPoint(60, 10));
  QTest::keyClick(&rows, Qt::Key_Escape);
  QTest::mouseRelease(&rows, Qt::LeftButton, {}, at + QPoint(60, 10));
  rows.repaint();
  CHECK(document.scene() == left);
}

TEST_CASE("A key that is held stays in the hand while other tracks come and go") {
  TimelineFixture fixture(sceneWithThreeTracks());
  ui::TrackRows& rows = fixture.timeline.rows();
  ui::Document& document = fixture.session.document();
  const QPoint at = rows.pointOf({2, 2}).toPoint();
  QTest::mousePress(&rows, Qt::LeftButton, {}, at);
  removeTrack(document, 0);
  const modeling::SceneTrack other = document.scene().tracks[0];
  QTest::mouseMove(&rows, at + QPoint(30, 0));
  QTest::mouseRelease(&rows, Qt::LeftButton, {}, at + QPoint(30, 0));
  CHECK(document.scene().tracks[0] == other);
  CHECK(document.scene().tracks[1].keys[2].time > 0.05);
}

TEST_CASE("What is selected and open stays with its track and key") {
  TimelineFixture fixture(sceneWithThreeTracks());
  ui::TrackRows& rows = fixture.timeline.rows();
  ui::Document& document = fixture.session.document();
  rows.setExpanded(2, true);
  QTest::mouseClick(&rows, Qt::LeftButton, {}, rows.pointOf({2, 1}).toPoint());
  REQUIRE(rows.selectedKey() == ui::KeyPlace{2, 1});
  removeTrack(document, 1);
  CHECK(rows.selectedKey() == ui::KeyPlace{1, 1});
  CHECK(rows.isExpanded(1));
  CHECK_FALSE(rows.isExpanded(2));
  document.edit("Add", [](Scene& scene) { modeling::addKey(scene.tracks[1], 0.01, 1.0); });
  CHECK(rows.selectedKey() == ui::KeyPlace{1, 2});
  document.edit("Remove", [](Scene& scene) { modeling::removeKey(scene, 1, 2); });
  CHECK_FALSE(rows.selectedKey());
  document.undoStack().undo();
  CHECK_FALSE(rows.selectedKey());
}

TEST_CASE("Fields beside a key stay with it, and go when it goes") {
  TimelineFixture fixture(sceneWithThreeTracks());
  ui::TrackRows& rows = fixture.timeline.rows();
  ui::Document& document = fixture.session.document();
  QTest::mouseDClick(&rows, Qt::LeftButton, {}, rows.pointOf({2, 1}).toPoint());
  QPointer<ui::KeyPopup> popup = rows.findChild<ui::KeyPopup*>();
  REQUIRE(popup);
  const QList<QDoubleSpinBox*> fields = popup->findChildren<QDoubleSpinBox*>();
  removeTrack(document, 0);
  REQUIRE(popup->isVisible());
  SECTION("another track is gone") {
    fields[1]->setValue(7.0);
    QTest::keyClick(fields[1], Qt::Key_Return);
    CHECK(std::get<double>(document.scene().tracks[1].keys[1].value) == 7.0);
  }
  SECTION("its own track is gone") {
    removeTrack(document, 1);
    CHECK((!popup || !popup->isVisible()));
    const Scene left = document.scene();
    if (popup) QTest::keyClick(fields[1], Qt::Key_Return);
    CHECK(document.scene() == left);
  }
}

TEST_CASE("The menu of a track closes when its track goes while it is open") {
  TimelineFixture fixture(sceneWithThreeTracks());
  ui::TrackRows& rows = fixture.timeline.rows();
  ui::Document& document = fixture.session.document();
  QTest::mouseClick(&rows, Qt::LeftButton, {}, rows.pointOf({2, 2}).toPoint());
  bool closed = false;
  QTimer removes;
  QObject::connect(&removes, &QTimer::timeout, [&] {
    QWidget* menu = QApplication::activePopupWidget();
    if (menu == nullptr) return;
    removes.stop();
    document.edit("None", [](Scene& scene) { scene.tracks.clear(); });
    closed = !menu->isVisible();
    menu->close();
  });
  removes.start(5);
  const QPoint at = rows.pointOf({2, 2}).toPoint();
  QContextMenuEvent asks(QContextMenuEvent::Mouse, at, rows.mapToGlobal(at));
  QApplication::sendEvent(&rows, &asks);
  CHECK(closed);
}

TEST_CASE("Frames of a scene that has been changed since are hatched") {
  TimelineFixture fixture(tests::fallingSlab());
  fixture.simulateToEnd();
  const QRect film(QPoint(qRound(fixture.timeline.bar().xOf(0.02)), ui::TimeBar::kRulerHeight + 4),
                   QSize(80, 20));
  // Above the marks of the frames a fresh take is all of one colour.
  const auto coloursSeen = [&] {
    const QImage picture = fixture.timeline.bar().grab(film).toImage();
    std::set<QRgb> colours;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) colours.insert(picture.pixel(x, y));
    return colours.size();
  };
  const std::size_t fresh = coloursSeen();
  fixture.session.document().edit("Heavier", [](Scene& scene) { scene.environment.gravity.z() = -500.0; });
  REQUIRE(fixture.session.takes()[0].stale);
  CHECK(coloursSeen() > fresh);
  fixture.session.document().undoStack().undo();
  CHECK(coloursSeen() == fresh);
}

TEST_CASE("A key stays between its neighbours, and the last one takes its track along") {
  Scene scene = sceneWithTrack();
  modeling::SceneTrack& track = scene.tracks[0];
  modeling::addKey(track, 0.02, 5.0);
  modeling::moveKey(track, 1, 7.0);
  CHECK(track.keys[1].time < track.keys[2].time);
  modeling::moveKey(track, 1, -7.0);
  CHECK(track.keys[1].time > track.keys[0].time);
  CHECK(modeling::checkScene(scene));
  modeling::removeKey(scene, 0, 0);
  modeling::removeKey(scene, 0, 0);
  CHECK(scene.tracks[0].keys.size() == 1);
  modeling::removeKey(scene, 0, 0);
  CHECK(scene.tracks.empty());
}

TEST_CASE("A new track changes nothing about the motion's values") {
  Scene scene = tests::fallingSlab();
  scene.environment.colliders[0].position = sim::Vec3(1.0, 2.0, 3.0);
  for (const modeling::TargetName& target : modeling::targetsOf(scene)) {
    const std::size_t track = modeling::addTrack(scene, target);
    CHECK(scene.tracks[track].target == target);
  }
  REQUIRE(modeling::checkScene(scene));
  for (const modeling::SceneTrack& track : scene.tracks) {
    if (track.target.target == sim::TrackTarget::gravity)
      CHECK(modeling::asVector(track.keys[0].value) == scene.environment.gravity);
    if (track.target.target == sim::TrackTarget::colliderPosition)
      CHECK(modeling::asVector(track.keys[0].value) == sim::Vec3(1.0, 2.0, 3.0));
    if (!track.target.isVector()) CHECK(std::get<double>(track.keys[0].value) == 1.0);
  }
}

}  // namespace
