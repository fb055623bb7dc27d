#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include <catch2/catch.hpp>

#include "ui/document/new_scene.h"
#include "ui/editors/calibration_chart.h"
#include "ui/editors/threshold_dialog.h"
#include "ui/panels/number_field.h"

using namespace ui;

namespace {

struct Fixture {
  QTemporaryDir folder;
  Session session{std::filesystem::path(folder.path().toStdString())};
  QPointer<ThresholdDialog> dialog;

  Fixture() {
    session.document().reset(newScene(), {});
    dialog = new ThresholdDialog(session, 0, nullptr);
    dialog->show();
  }
  ~Fixture() { delete dialog; }

  template <class Widget>
  Widget& find(const char* name) {
    auto* widget = dialog->findChild<Widget*>(QString::fromLatin1(name));
    REQUIRE(widget != nullptr);
    return *widget;
  }
  void click(const char* name) { QTest::mouseClick(&find<QPushButton>(name), Qt::LeftButton); }
};

}  // namespace

TEST_CASE("Samples appear one after the other, and what is offered becomes the material's in one step",
          "[threshold]") {
  Fixture fixture;
  fixture.click("threshold-start");
  REQUIRE(QTest::qWaitFor([&] { return fixture.dialog->progress().ended; }, 300000));
  const CalibrationProgress& progress = fixture.dialog->progress();
  REQUIRE_FALSE(progress.problem);
  CHECK(fixture.dialog->findChild<CalibrationChart*>()->pointCount() == progress.trials.size());
  REQUIRE(progress.threshold);
  const modeling::Scene before = fixture.session.document().scene();
  const double offered = *progress.threshold;
  fixture.click("threshold-use");
  const modeling::Material& used = fixture.session.document().scene().materials[0].values;
  REQUIRE(used.threshold.mean);
  CHECK(*used.threshold.mean == Approx(offered).epsilon(0.06));
  CHECK_FALSE(used.strength);
  CHECK(fixture.session.document().undoStack().count() == 1);
  fixture.session.document().undoStack().undo();
  CHECK(fixture.session.document().scene() == before);
}

TEST_CASE("Tuning a threshold stops when asked, and keeps what was found", "[threshold]") {
  Fixture fixture;
  fixture.click("threshold-start");
  REQUIRE(QTest::qWaitFor([&] { return !fixture.dialog->progress().trials.empty(); }, 300000));
  fixture.click("threshold-start");
  REQUIRE(QTest::qWaitFor([&] { return fixture.dialog->progress().ended; }, 300000));
  CHECK_FALSE(fixture.dialog->progress().trials.empty());
  CHECK(fixture.find<QPushButton>("threshold-start").isEnabled());
}
