#include "ui/panels/takes_panel.h"

#include <QLineEdit>
#include <QListView>
#include <QTest>

#include <catch2/catch.hpp>

#include "tests/ui/window_scenes.h"
#include "ui/timeline/play_actions.h"

namespace {

struct TakesFixture : tests::SessionFixture {
  ui::PlayActions actions{session};
  ui::TakesPanel panel{session, actions};
  QListView* list = panel.findChild<QListView*>();

  TakesFixture() {
    load(tests::fallingSlab());
    panel.resize(300, 500);
    panel.show();
    REQUIRE(QTest::qWaitForWindowExposed(&panel));
  }
};

TEST_CASE("Each run becomes a take in the list, and a click puts another on the timeline") {
  TakesFixture fixture;
  CHECK_FALSE(fixture.list->isVisible());
  fixture.simulateToEnd();
  REQUIRE(fixture.list->isVisible());
  fixture.session.document().edit("Gravity",
                                  [](modeling::Scene& scene) { scene.environment.gravity.z() = -10.0; });
  fixture.simulateToEnd();
  REQUIRE(tests::becomesTrue([&] { return fixture.list->model()->rowCount() == 2; }));
  CHECK(fixture.session.takes().current() == 1);
  const QRect first = fixture.list->visualRect(fixture.list->model()->index(0, 0));
  QTest::mouseClick(fixture.list->viewport(), Qt::LeftButton, {}, first.center());
  CHECK(fixture.session.takes().current() == 0);
  CHECK(fixture.session.playback().footage() == fixture.session.takes()[0].footage);
  CHECK(fixture.session.takes()[0].stale);
  CHECK_FALSE(fixture.session.takes()[1].stale);
}

TEST_CASE("A take is renamed in the list and noted below it") {
  TakesFixture fixture;
  fixture.simulateToEnd();
  const QModelIndex index = fixture.list->model()->index(0, 0);
  CHECK(index.data().toString() == "Take 1");
  CHECK(fixture.list->model()->setData(index, "The good one", Qt::EditRole));
  CHECK(fixture.session.takes()[0].name == "The good one");
  CHECK_FALSE(fixture.list->model()->setData(index, "  ", Qt::EditRole));
  auto* note = fixture.panel.findChild<QLineEdit*>("takeNote");
  QTest::keyClicks(note, "it bounces");
  QTest::keyClick(note, Qt::Key_Return);
  CHECK(fixture.session.takes()[0].note == "it bounces");
  const std::filesystem::path file = fixture.session.takes()[0].footage->file();
  CHECK(std::filesystem::exists(file));
  fixture.session.takes().remove(0);
  CHECK_FALSE(std::filesystem::exists(file));
  CHECK_FALSE(fixture.list->isVisible());
}

}  // namespace
