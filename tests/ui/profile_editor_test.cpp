#include "ui/editors/profile_editor.h"

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include <catch2/catch.hpp>

#include "modeling/shapes/measured_chain.h"
#include "ui/editors/profile_canvas.h"

using modeling::RevolutionShape;
using modeling::Vec2;
using namespace ui;

namespace {

modeling::Scene cupScene() {
  modeling::Scene scene;
  modeling::SceneMaterial material;
  material.name = material.values.name = "clay";
  scene.materials.push_back(material);
  modeling::Part part;
  part.name = "cup";
  part.material = "clay";
  part.shape = shapeOf(ProfilePreset::cup);
  scene.parts.push_back(part);
  return scene;
}

struct Fixture {
  QTemporaryDir folder;
  Session session{std::filesystem::path(folder.path().toStdString())};
  ProfileEditor editor{session};

  Fixture() {
    session.document().reset(cupScene(), {});
    session.selection().select({ItemKind::part, 0});
    editor.resize(640, 480);
    editor.show();
    REQUIRE(QTest::qWaitForWindowExposed(&editor));
    editor.canvas().frame();
    editor.canvas().setFocus();
  }
  ProfileCanvas& canvas() { return editor.canvas(); }
  const RevolutionShape& shape() {
    return std::get<RevolutionShape>(session.document().scene().parts[0].shape);
  }
  int steps() { return session.document().undoStack().index(); }
  QPoint pixel(const Vec2& at) { return canvas().view().toPixel(at).toPoint(); }
  QPoint pixel(const ControlId& control) { return pixel(canvas().model()->position(control)); }
  void drag(const QPoint& from, const QPoint& by, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mousePress(&canvas(), Qt::LeftButton, modifiers, from);
    // Moves need a held button, which QTest::mouseMove does not say.
    for (const int part : {1, 2, 3, 4}) {
      const QPointF to = from + QPointF(by) * part / 4.0;
      QMouseEvent move(QEvent::MouseMove, to, canvas().mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                       modifiers);
      QApplication::sendEvent(&canvas(), &move);
    }
    QTest::mouseRelease(&canvas(), Qt::LeftButton, modifiers, from + by);
  }
  /// Undo and redo bring back exactly what was and what is.
  void requireUndoable(const modeling::Scene& before) {
    const modeling::Scene after = session.document().scene();
    session.document().undoStack().undo();
    CHECK(session.document().scene() == before);
    session.document().undoStack().redo();
    CHECK(session.document().scene() == after);
    CHECK(canvas().model()->shape() == shape());
  }
};

const ControlId kMiddle{ProfileSide::outside, 6};

}  // namespace

TEST_CASE("A point dragged in the profile moves the part's profile, in one step", "[profile]") {
  Fixture fixture;
  const modeling::Scene before = fixture.session.document().scene();
  const Vec2 from = fixture.canvas().model()->position(kMiddle);
  fixture.drag(fixture.pixel(kMiddle), {30, -20});
  CHECK(fixture.steps() == 1);
  const Vec2 to = fixture.shape().outside[1][3];
  CHECK((to - from).x() == Approx(30 / fixture.canvas().view().scale()).margin(0.15));
  CHECK((to - from).y() == Approx(20 / fixture.canvas().view().scale()).margin(0.15));
  fixture.requireUndoable(before);
}

TEST_CASE("The lattice follows while a profile is dragged", "[profile]") {
  Fixture fixture;
  const auto built = [&] {
    const auto& preview = fixture.session.preview();
    return !fixture.session.isBuilding() && preview->built &&
           preview->scene == fixture.session.document().scene();
  };
  REQUIRE(QTest::qWaitFor(built, 60000));
  const auto before = fixture.session.preview();
  QTest::mousePress(&fixture.canvas(), Qt::LeftButton, {}, fixture.pixel(kMiddle));
  const QPointF to = fixture.pixel(kMiddle) + QPointF(15, 0);
  QMouseEvent move(QEvent::MouseMove, to, fixture.canvas().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(&fixture.canvas(), &move);
  REQUIRE(QTest::qWaitFor(built, 60000));
  CHECK(fixture.session.preview() != before);
  QTest::mouseRelease(&fixture.canvas(), Qt::LeftButton, {}, to.toPoint());
}

TEST_CASE("Esc takes a drag of the profile back", "[profile]") {
  Fixture fixture;
  const modeling::Scene before = fixture.session.document().scene();
  const QPoint from = fixture.pixel(kMiddle);
  QTest::mousePress(&fixture.canvas(), Qt::LeftButton, {}, from);
  const QPointF to = from + QPointF(30, 0);
  QMouseEvent move(QEvent::MouseMove, to, fixture.canvas().mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(&fixture.canvas(), &move);
  CHECK(fixture.session.document().scene() != before);
  QTest::keyClick(&fixture.canvas(), Qt::Key_Escape);
  CHECK(fixture.session.document().scene() == before);
  QTest::mouseRelease(&fixture.canvas(), Qt::LeftButton, {}, to.toPoint());
  CHECK(fixture.session.document().scene() == before);
}

TEST_CASE("A double click on a curve adds a point, Del takes it out", "[profile]") {
  Fixture fixture;
  const modeling::Scene before = fixture.session.document().scene();
  const QPoint place = fixture.pixel(modeling::evaluate(fixture.shape().outside[2], 0.5));
  QTest::mouseDClick(&fixture.canvas(), Qt::LeftButton, {}, place);
  CHECK(fixture.shape().outside.size() == 4);
  CHECK(fixture.shape().inside.size() == 4);
  CHECK(fixture.steps() == 1);
  fixture.requireUndoable(before);
  const modeling::Scene inserted = fixture.session.document().scene();
  fixture.canvas().setSelected({{ProfileSide::outside, 9}});
  QTest::keyClick(&fixture.canvas(), Qt::Key_Delete);
  CHECK(fixture.shape().outside.size() == 3);
  CHECK(fixture.steps() == 2);
  fixture.requireUndoable(inserted);
}

TEST_CASE("The insert tool adds a point where a curve is clicked", "[profile]") {
  Fixture fixture;
  QTest::keyClick(&fixture.canvas(), Qt::Key_I);
  CHECK(fixture.canvas().mode() == ProfileCanvas::Mode::insert);
  QTest::mouseClick(&fixture.canvas(), Qt::LeftButton, {},
                    fixture.pixel(modeling::evaluate(fixture.shape().inside[2], 0.4)));
  CHECK(fixture.shape().inside.size() == 4);
  CHECK(fixture.canvas().selected() == ControlSet{{ProfileSide::inside, 9}});
  QTest::keyClick(&fixture.canvas(), Qt::Key_Escape);
  CHECK(fixture.canvas().mode() == ProfileCanvas::Mode::select);
}

TEST_CASE("Keys smooth, sharpen, straighten and nudge the selected points", "[profile]") {
  Fixture fixture;
  QTest::mouseClick(&fixture.canvas(), Qt::LeftButton, {}, fixture.pixel(kMiddle));
  REQUIRE(fixture.canvas().selected() == ControlSet{kMiddle});
  for (const Qt::Key key : {Qt::Key_C, Qt::Key_S, Qt::Key_L, Qt::Key_Right, Qt::Key_Up}) {
    CAPTURE(int(key));
    const modeling::Scene before = fixture.session.document().scene();
    const int steps = fixture.steps();
    QTest::keyClick(&fixture.canvas(), key);
    CHECK(fixture.steps() == steps + 1);
    fixture.requireUndoable(before);
    if (key == Qt::Key_C) CHECK_FALSE(fixture.canvas().model()->isSmooth(kMiddle));
    if (key == Qt::Key_S) CHECK(fixture.canvas().model()->isSmooth(kMiddle));
  }
}

TEST_CASE("The button offsets the inside by the wall's thickness", "[profile]") {
  Fixture fixture;
  const modeling::Scene before = fixture.session.document().scene();
  fixture.canvas().setSelected({});
  auto* button = fixture.editor.findChild<QPushButton*>(QStringLiteral("profile-offset"));
  REQUIRE(button != nullptr);
  QTest::mouseClick(button, Qt::LeftButton);
  CHECK(fixture.steps() == 1);
  fixture.requireUndoable(before);
}

TEST_CASE("A preset takes the profile's place and keeps the part's", "[profile]") {
  Fixture fixture;
  const modeling::Scene before = fixture.session.document().scene();
  for (const ProfilePreset preset : kProfilePresets) {
    fixture.editor.usePreset(preset);
    CHECK(fixture.shape() == shapeOf(preset));
    CHECK(fixture.session.document().scene().parts[0].material == "clay");
  }
  while (fixture.session.document().undoStack().canUndo()) fixture.session.document().undoStack().undo();
  CHECK(fixture.session.document().scene() == before);
}

TEST_CASE("What is wrong with a wall is said where it is drawn", "[profile]") {
  Fixture fixture;
  auto* message = fixture.editor.findChild<QLabel*>(QStringLiteral("profile-message"));
  REQUIRE(message != nullptr);
  CHECK(message->text().isEmpty());
  fixture.canvas().setSelected({{ProfileSide::inside, 6}});
  fixture.canvas().apply(QStringLiteral("move"), [](ProfileModel& model) {
    model.move({{ProfileSide::inside, 6}}, Vec2(3.0, 0.0));
    return sim::Done{};
  });
  CHECK(message->text().contains(QStringLiteral("cross")));
  fixture.session.document().undoStack().undo();
  CHECK(message->text().isEmpty());
}

TEST_CASE("The editor is empty until a solid of revolution is selected", "[profile]") {
  Fixture fixture;
  modeling::Scene scene = cupScene();
  modeling::Part slab;
  slab.name = "slab";
  slab.material = "clay";
  slab.shape = modeling::SlabShape{};
  scene.parts.push_back(slab);
  fixture.session.document().reset(scene, {});
  fixture.session.selection().select({ItemKind::part, 1});
  CHECK_FALSE(fixture.canvas().model());
  auto* button = fixture.editor.findChild<QPushButton*>(QStringLiteral("profile-select-part"));
  REQUIRE(button != nullptr);
  QTest::mouseClick(button, Qt::LeftButton);
  CHECK(fixture.session.selection().current() == Item{ItemKind::part, 0});
  CHECK(fixture.canvas().model());
}
