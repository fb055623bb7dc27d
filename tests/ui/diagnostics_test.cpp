#include <QChart>
#include <QChartView>
#include <QCheckBox>
#include <QLineSeries>
#include <QTest>
#include <algorithm>

#include <catch2/catch.hpp>

#include "tests/ui/window_scenes.h"
#include "ui/panels/diagnostics_panel.h"
#include "ui/panels/inspection.h"
#include "ui/timeline/note_feed.h"
#include "ui/timeline/time_axis.h"

namespace {

ui::PlotLine brokenBonds() {
  return {"broken", [](const ui::FrameNote& note) { return double(note.brokenBonds); }, false};
}

TEST_CASE("However few points are drawn, no peak is lost") {
  std::vector<ui::FrameNote> notes(10000);
  for (std::size_t frame = 0; frame < notes.size(); ++frame) notes[frame].time = 1e-3 * double(frame);
  notes[7321].brokenBonds = 50;
  const QList<QPointF> points = ui::decimated(notes, brokenBonds(), 0.0, 20.0, 300);
  CHECK(points.size() <= 600);
  const auto highest = std::max_element(points.begin(), points.end(),
                                        [](const QPointF& a, const QPointF& b) { return a.y() < b.y(); });
  CHECK(highest->y() == 50.0);
  CHECK(highest->x() == Approx(7.321));
  CHECK(std::is_sorted(points.begin(), points.end(),
                       [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); }));
}

TEST_CASE("Of a stretch of time only what is in it is drawn, and the line goes on beyond") {
  std::vector<ui::FrameNote> notes(100);
  for (std::size_t frame = 0; frame < notes.size(); ++frame) notes[frame].time = double(frame);
  const QList<QPointF> points = ui::decimated(notes, brokenBonds(), 10.5, 20.5, 300);
  CHECK(points.front().x() == 10.0);
  CHECK(points.back().x() == 21.0);
}

TEST_CASE("Numbers are short") {
  CHECK(ui::shortNumber(1234567.0) == "1.23 M");
  CHECK(ui::shortNumber(-23456.0) == "-23.5 k");
  CHECK(ui::shortNumber(0.0) == "0");
  CHECK(ui::shortNumber(0.5) == "0.5");
}

TEST_CASE("A click on a plot goes to that moment, and a line can be left out") {
  tests::SessionFixture fixture;
  fixture.load(tests::fallingSlab());
  ui::NoteFeed feed(fixture.session);
  ui::TimeAxis axis;
  axis.setWidth(800.0);
  axis.setEnd(0.1);
  ui::DiagnosticsPanel panel(fixture.session, feed, axis);
  panel.resize(800, 240);
  panel.show();
  REQUIRE(QTest::qWaitForWindowExposed(&panel));
  fixture.simulateToEnd();
  auto* view = panel.findChild<QChartView*>();
  auto* series = static_cast<QLineSeries*>(view->chart()->series().first());
  REQUIRE(tests::becomesTrue([&] { return series->count() == 11; }));
  QTest::qWait(50);
  const QPointF at = view->chart()->mapToPosition({0.052, 0.0}, series);
  QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, view->mapFromScene(view->chart()->mapToScene(at)));
  CHECK(fixture.session.playback().frame() == 5);
  auto* box = panel.findChildren<QCheckBox*>().first();
  box->click();
  CHECK_FALSE(series->isVisible());
}

TEST_CASE("A broken bond says when and why, a whole one how far it is from breaking") {
  tests::SessionFixture fixture;
  fixture.load(tests::breakingSlab());
  ui::Pick pick;
  pick.kind = ui::Pick::Kind::bond;
  pick.index = 0;
  const ui::Inspection whole = ui::inspect(pick, fixture.session.shown(), std::nullopt);
  CHECK(whole.title == "Bond 0");
  REQUIRE(whole.strainOfThreshold);
  CHECK(*whole.strainOfThreshold == Approx(0.0).margin(1e-9));
  fixture.simulateToEnd();
  const auto events = fixture.session.playback().footage()->events();
  REQUIRE(events);
  REQUIRE_FALSE(events->empty());
  pick.index = events->front().bond;
  REQUIRE(ui::isBroken(pick, fixture.session.shown()));
  const ui::Inspection broken = ui::inspect(pick, fixture.session.shown(), events->front());
  CHECK_FALSE(broken.strainOfThreshold);
  CHECK(std::any_of(broken.facts.begin(), broken.facts.end(),
                    [](const ui::Fact& fact) { return fact.name == "Broke at"; }));
  pick.kind = ui::Pick::Kind::fragment;
  pick.index = *broken.fragment;
  CHECK(ui::inspect(pick, fixture.session.shown(), std::nullopt).facts.size() >= 6);
}

}  // namespace
