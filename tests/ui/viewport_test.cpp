#include "ui/viewport/viewport.h"

#include <QLabel>
#include <QTemporaryDir>
#include <QTest>
#include <QUndoStack>
#include <functional>

#include <catch2/catch.hpp>

#include "tests/ui/viewport_examples.h"
#include "ui/document/scene_edits.h"
#include "ui/viewport/transform_tool.h"
#include "ui/viewport/view_actions.h"

namespace {

bool becomesTrue(const std::function<bool()>& condition) {
  return QTest::qWaitFor(condition, 60000);
}

/// A viewport on the screen with the block and the ball, seen from the front.
struct Stage {
  QTemporaryDir folder;
  ui::Session session{std::filesystem::path(folder.path().toStdString())};
  ui::Viewport viewport{session};

  Stage() {
    viewport.resize(320, 240);
    viewport.show();
    REQUIRE(QTest::qWaitForWindowExposed(&viewport));
    session.document().reset(examples::blockAndBall(), {});
    REQUIRE(becomesTrue([&] { return session.shown().moment && viewport.isUpToDate(); }));
    viewport.camera().look({-1.0, 0.0, 1.5}, 24.0, -1.5707963, 0.25);
    viewport.update();
    viewport.activateWindow();
    REQUIRE(QTest::qWaitForWindowActive(&viewport));
    viewport.setFocus();
  }

  const modeling::Scene& scene() { return session.document().scene(); }
  const sim::Vec3& blockPosition() { return scene().parts[0].worldFromPart.position; }
  QPoint at(const sim::Vec3& point) { return viewport.project(point)->toPoint(); }
  void selectBlock() { session.selection().select({ui::ItemKind::part, 0}); }
  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::mousePress(&viewport, Qt::LeftButton, modifiers, from);
    QMouseEvent move(QEvent::MouseMove, to, viewport.mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                     modifiers);
    QCoreApplication::sendEvent(&viewport, &move);
    QTest::mouseRelease(&viewport, Qt::LeftButton, modifiers, to);
  }
};

TEST_CASE("A scene that is loaded is brought into view") {
  Stage stage;
  stage.session.document().reset(examples::blockAndBall(), {});
  REQUIRE(becomesTrue([&] { return !stage.session.isBuilding() && stage.viewport.isUpToDate(); }));
  CHECK(stage.viewport.camera().sees(stage.viewport.drawn()->box, stage.viewport.viewSize()));
}

TEST_CASE("A click selects what is under it, with shift as well, and nothing beside it") {
  Stage stage;
  ui::Selection& selection = stage.session.selection();
  QTest::mouseClick(&stage.viewport, Qt::LeftButton, Qt::NoModifier, stage.at({0.0, -2.0, 1.5}));
  REQUIRE(selection.items().size() == 1);
  CHECK(selection.current() == ui::Item{ui::ItemKind::part, 0});
  QTest::mouseClick(&stage.viewport, Qt::LeftButton, Qt::ShiftModifier, stage.at({-6.0, 0.0, 1.5}));
  CHECK(selection.items().size() == 2);
  CHECK(selection.current() == ui::Item{ui::ItemKind::collider, 1});
  QTest::mouseClick(&stage.viewport, Qt::LeftButton, Qt::NoModifier, QPoint(160, 20));
  CHECK(selection.items().empty());
}

TEST_CASE("A frame drawn around things selects those that are not locked, and with shift adds them") {
  Stage stage;
  ui::Selection& selection = stage.session.selection();
  const auto drag = [&](const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers) {
    QTest::mousePress(&stage.viewport, Qt::LeftButton, modifiers, from);
    QTest::mouseMove(&stage.viewport, (from + to) / 2);
    QTest::mouseMove(&stage.viewport, to);
    QTest::mouseRelease(&stage.viewport, Qt::LeftButton, modifiers, to);
  };
  const QRect all = stage.viewport.rect().adjusted(2, 2, -2, -2);
  drag(all.topLeft(), all.bottomRight() - QPoint(0, 0), Qt::NoModifier);
  CHECK(selection.contains({ui::ItemKind::part, 0}));
  CHECK(selection.contains({ui::ItemKind::collider, 1}));
  CHECK_FALSE(selection.contains({ui::ItemKind::collider, 0}));  // the floor
  const QPoint ball = stage.at({-6.0, 0.0, 1.5});
  drag(ball - QPoint(40, 40), ball + QPoint(4, 4), Qt::NoModifier);
  CHECK(selection.items() == std::vector<ui::Item>{{ui::ItemKind::collider, 1}});
  drag(all.topLeft(), all.bottomRight(), Qt::ShiftModifier);
  CHECK(selection.items().size() == 2);
}

TEST_CASE("Clicks pass over what is locked") {
  Stage stage;
  const QPoint onBlock = stage.at({0.0, -2.0, 1.5});
  const ui::Pick before = stage.viewport.pickAt(onBlock);
  REQUIRE(before.item == ui::Item{ui::ItemKind::part, 0});
  stage.session.document().edit("Lock", [](modeling::Scene& scene) {
    ui::setLocked(scene, {ui::ItemKind::part, 0}, true);
    ui::setLocked(scene, {ui::ItemKind::collider, 1}, true);
  });
  REQUIRE(becomesTrue([&] { return !stage.session.isBuilding() && stage.viewport.isUpToDate(); }));
  CHECK(stage.viewport.pickAt(onBlock).item != before.item);
  CHECK(stage.viewport.pickAt(stage.at({-6.0, 0.0, 1.5})).item != ui::Item{ui::ItemKind::collider, 1});
}

TEST_CASE("The pointer is told what it is over") {
  Stage stage;
  CHECK(stage.viewport.describe(stage.viewport.pickAt(stage.at({0.0, -2.0, 1.5}))).contains("block"));
  CHECK(stage.viewport.describe(stage.viewport.pickAt(stage.at({-6.0, 0.0, 1.5}))).contains("ball"));
  ui::ViewSettings settings;
  settings.surface = false;
  settings.bonds = true;
  stage.viewport.setViewSettings(settings);
  REQUIRE(becomesTrue([&] { return stage.viewport.isUpToDate(); }));
  const sim::Vec3 onEdge(-2.5, -2.0, 3.0);
  const ui::Pick pick = stage.viewport.pickAt(*stage.viewport.project(onEdge));
  REQUIRE(pick.kind == ui::Pick::Kind::bond);
  const QString text = stage.viewport.describe(pick);
  CHECK(text.contains("threshold 5 %"));
  CHECK(text.contains("strain"));
}

TEST_CASE("Dragging an arrow moves a part along its axis, as one step that can be undone") {
  Stage stage;
  stage.selectBlock();
  stage.viewport.setTool(std::make_unique<ui::TransformTool>(ui::TransformMode::move));
  const modeling::Scene before = stage.scene();
  const QPoint middle = stage.at({0.0, 0.0, 1.5});
  const QPoint arrow = middle + QPoint(60, 0);
  stage.drag(arrow, arrow + QPoint(30, 12));
  const double moved = stage.blockPosition().x();
  const double pixel = stage.viewport.camera().pixelSize({0.0, 0.0, 1.5}, stage.viewport.viewSize());
  CHECK(moved == Approx(30.0 * pixel).epsilon(0.15));
  CHECK(stage.blockPosition().y() == 0.0);
  CHECK(stage.blockPosition().z() == 0.0);
  QUndoStack& undo = stage.session.document().undoStack();
  CHECK(undo.count() == 1);
  undo.undo();
  CHECK(stage.scene() == before);
  undo.redo();
  CHECK(stage.blockPosition().x() == moved);
}

TEST_CASE("With ctrl an arrow moves by whole centimetres") {
  Stage stage;
  stage.selectBlock();
  stage.viewport.setTool(std::make_unique<ui::TransformTool>(ui::TransformMode::move));
  const QPoint arrow = stage.at({0.0, 0.0, 1.5}) + QPoint(60, 0);
  stage.drag(arrow, arrow + QPoint(37, 0), Qt::ControlModifier);
  CHECK(stage.blockPosition().x() != 0.0);
  CHECK(stage.blockPosition().x() == std::round(stage.blockPosition().x()));
}

TEST_CASE("A typed number counts instead of the pointer") {
  Stage stage;
  stage.selectBlock();
  auto tool = std::make_unique<ui::TransformTool>(ui::TransformMode::move);
  ui::TransformTool& move = *tool;
  stage.viewport.setTool(std::move(tool));
  REQUIRE(move.grab(stage.viewport, QPointF(200.0, 100.0)));
  QTest::keyClicks(&stage.viewport, QStringLiteral("x2.5"));
  CHECK(stage.blockPosition() == sim::Vec3(2.5, 0.0, 0.0));
  QTest::keyClick(&stage.viewport, Qt::Key_Minus);
  CHECK(stage.blockPosition() == sim::Vec3(-2.5, 0.0, 0.0));
  QTest::keyClick(&stage.viewport, Qt::Key_Return);
  CHECK_FALSE(move.isDragging());
  CHECK(stage.session.document().undoStack().count() == 1);
}

TEST_CASE("Esc takes back what is under way, and leaves no step behind") {
  Stage stage;
  stage.selectBlock();
  const modeling::Scene before = stage.scene();
  for (const auto mode : {ui::TransformMode::move, ui::TransformMode::rotate, ui::TransformMode::scale}) {
    auto tool = std::make_unique<ui::TransformTool>(mode);
    ui::TransformTool& transform = *tool;
    stage.viewport.setTool(std::move(tool));
    REQUIRE(transform.grab(stage.viewport, QPointF(200.0, 100.0)));
    QTest::keyClick(&stage.viewport, Qt::Key_3);
    CHECK_FALSE(stage.scene() == before);
    QTest::keyClick(&stage.viewport, Qt::Key_Escape);
    CHECK(stage.scene() == before);
    CHECK(stage.session.document().undoStack().count() == 0);
  }
  QTest::keyClick(&stage.viewport, Qt::Key_Escape);
  CHECK(stage.viewport.tool() == nullptr);
}

TEST_CASE("Keys look along axes, and the view is there a moment later") {
  Stage stage;
  ui::ViewActions actions(stage.viewport);
  QTest::keyClick(&stage.viewport, Qt::Key_3);
  CHECK(becomesTrue([&] { return stage.viewport.camera().forward().isApprox(-sim::Vec3::UnitX(), 1e-3); }));
  QTest::keyClick(&stage.viewport, Qt::Key_1, Qt::ControlModifier);
  CHECK(becomesTrue([&] { return stage.viewport.camera().forward().isApprox(-sim::Vec3::UnitY(), 1e-3); }));
  QTest::keyClick(&stage.viewport, Qt::Key_5);
  CHECK(stage.viewport.camera().isOrthographic());
}

TEST_CASE("Turning the view uploads nothing") {
  Stage stage;
  stage.viewport.grabFramebuffer();
  const std::uint64_t before = stage.viewport.statistics().uploadsInAll;
  stage.viewport.camera().orbit(0.4, 0.1);
  stage.viewport.grabFramebuffer();
  CHECK(stage.viewport.statistics().uploadsInAll == before);
}

}  // namespace
