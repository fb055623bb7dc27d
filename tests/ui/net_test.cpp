// What event handlers throw, and what the window does then.
#include <QLabel>
#include <QTest>
#include <QTimer>
#include <QUndoCommand>

#include <catch2/catch.hpp>

#include "modeling/scene/scene_file.h"
#include "tests/ui/expected_catches.h"
#include "tests/ui/whole_window.h"
#include "tests/ui/window_scenes.h"
#include "ui/window/application.h"
#include "ui/window/problem_bar.h"

namespace {

using tests::becomesTrue;

ui::Application& application() {
  return *static_cast<ui::Application*>(qApp);
}

/// Throws at each press, and at each picture where it is asked to.
class Throwing : public QWidget {
 public:
  using QWidget::QWidget;
  bool paints = false;
  int painted = 0;

 protected:
  void mousePressEvent(QMouseEvent*) override { throw std::out_of_range("a press"); }
  void paintEvent(QPaintEvent*) override {
    ++painted;
    if (paints) throw std::runtime_error("a picture");
  }
};

/// The whole window with its net, and how often it caught something meanwhile.
struct Net : tests::WholeWindow {
  ui::Autosave autosave{session, folder};
  int before = application().caughtCount();

  Net() {
    ui::spreadNet(application(), session, autosave);
    session.document().reset(tests::fallingSlab(), {});
    window.showViewport();
    session.document().edit("Heavier",
                            [](modeling::Scene& scene) { scene.environment.gravity.z() = -500.0; });
  }
  ~Net() { tests::expectedCatches() += caught(); }

  int caught() const { return application().caughtCount() - before; }
  ui::ProblemBar& bar() { return *window.findChild<ui::ProblemBar*>(); }
  bool tells(const char* words) { return bar().isVisible() && bar().text().contains(QLatin1String(words)); }
};

TEST_CASE("What a handler throws is told, the scene is put aside, and the window goes on") {
  Net net;
  SECTION("an event of a widget") {
    Throwing widget(&net.window);
    widget.setGeometry(0, 0, 50, 50);
    widget.show();
    QTest::mouseClick(&widget, Qt::LeftButton);
    CHECK(becomesTrue([&] { return net.tells("a press"); }));
  }
  SECTION("a timer") {
    QTimer::singleShot(0, &net.window, [] { throw std::out_of_range("a timer"); });
    CHECK(becomesTrue([&] { return net.tells("a timer"); }));
  }
  SECTION("a queued call") {
    QMetaObject::invokeMethod(
        &net.window, [] { throw std::out_of_range("a queued call"); }, Qt::QueuedConnection);
    CHECK(becomesTrue([&] { return net.tells("a queued call"); }));
  }
  SECTION("no exception of the library") {
    QTimer::singleShot(0, &net.window, [] { throw 7; });
    CHECK(becomesTrue([&] { return net.tells("nothing is known"); }));
  }
  CHECK(net.caught() == 1);
  const auto kept = modeling::loadScene(net.folder / "autosave.scene.json");
  REQUIRE(kept);
  CHECK(kept->scene == net.scene());
  net.session.document().undoStack().undo();
  CHECK(net.scene() == tests::fallingSlab());
}

TEST_CASE("What is thrown at every picture is told once") {
  Net net;
  int told = 0;
  const auto counting =
      QObject::connect(&application(), &ui::Application::caught, [&](const sim::Problem&) { ++told; });
  Throwing widget(&net.window);
  widget.paints = true;
  widget.setGeometry(0, 0, 50, 50);
  widget.show();
  CHECK(becomesTrue([&] {
    widget.update();
    return net.caught() > 30;
  }));
  QTest::qWait(1500);
  CHECK(told == 1);
  QObject::disconnect(counting);
}

TEST_CASE("A listener that throws does not tear the history") {
  Net net;
  ui::Document& document = net.session.document();
  const auto throwing = QObject::connect(&document, &ui::Document::sceneChanged, &net.window,
                                         [] { throw std::out_of_range("a listener"); });
  const int steps = document.undoStack().count();
  document.edit("Lighter", [](modeling::Scene& scene) { scene.environment.gravity.z() = -1.0; });
  CHECK(document.undoStack().count() == steps + 1);
  document.undoStack().undo();
  CHECK(document.undoStack().index() == steps);
  document.undoStack().redo();
  CHECK(document.scene().environment.gravity.z() == -1.0);
  CHECK(becomesTrue([&] { return net.tells("a listener"); }));
  QObject::disconnect(throwing);
}

}  // namespace
