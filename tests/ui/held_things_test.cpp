// What is grabbed, dragged, typed into or open while what it is of goes; and keys that are meant for it.
#include <QAction>
#include <QComboBox>
#include <QLineEdit>
#include <QTest>

#include <catch2/catch.hpp>

#include "tests/ui/whole_window.h"
#include "tests/ui/window_scenes.h"
#include "ui/document/new_scene.h"
#include "ui/document/scene_edits.h"
#include "ui/editors/glue_editing.h"
#include "ui/editors/points_tool.h"
#include "ui/editors/profile_canvas.h"
#include "ui/kinds/new_things.h"
#include "ui/panels/number_field.h"
#include "ui/panels/outliner_tree.h"
#include "ui/panels/preflight_dialog.h"
#include "ui/panels/touch_tool.h"
#include "ui/viewport/transform_tool.h"
#include "ui/viewport/viewport.h"

namespace {

using modeling::Scene;
using tests::becomesTrue;

/// Three slabs of these names, one beside the other.
Scene slabs(const std::vector<std::string>& names) {
  Scene scene = tests::fallingSlab();
  const modeling::Part one = scene.parts.front();
  scene.parts.clear();
  for (const std::string& name : names) {
    scene.parts.push_back(one);
    scene.parts.back().name = name;
    scene.parts.back().worldFromPart.position.x() = 10.0 * static_cast<double>(scene.parts.size());
  }
  return scene;
}

struct Hands : tests::WholeWindow {
  void load(const Scene& loaded) {
    session.document().reset(loaded, {});
    window.showViewport();
    REQUIRE(becomesTrue([&] { return !session.isBuilding() && viewport().isUpToDate(); }));
  }
  ui::Document& document() { return session.document(); }
  void selectPart(std::size_t part) { session.selection().select({ui::ItemKind::part, part}); }
  void removePart(std::size_t part) {
    document().edit("Delete", [part](Scene& scene) {
      ui::remove(scene, std::vector<ui::Item>{{ui::ItemKind::part, part}});
    });
  }
  ui::TransformTool& grab(std::size_t part) {
    selectPart(part);
    auto tool = std::make_unique<ui::TransformTool>(ui::TransformMode::move);
    ui::TransformTool& held = *tool;
    viewport().setTool(std::move(tool));
    viewport().setFocus();
    REQUIRE(held.grab(viewport(), QPointF(300, 300)));
    return held;
  }
  void pointAt(const QPoint& at) {
    QTest::mouseMove(viewport().window()->windowHandle(), viewport().mapTo(viewport().window(), at));
    QTest::qWait(20);
  }
  void pointAtViewport() {
    QCursor::setPos(viewport().mapToGlobal(viewport().rect().center()));
    REQUIRE(becomesTrue([&] { return viewport().underMouse(); }));
  }
  void pressKey(const char* keys) {
    const QKeySequence sequence(QString::fromLatin1(keys));
    QTest::keyClick(window.windowHandle(), sequence[0].key(), sequence[0].keyboardModifiers());
  }
  void clickOutliner() {
    auto& tree = *window.findChild<ui::OutlinerTree*>();
    const QPoint at = tree.visualItemRect(tree.rowOf({ui::ItemKind::part, 0})).center();
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, at);
    REQUIRE(tree.hasFocus());
  }
};

TEST_CASE("A part in the hand is let go where it goes, and nothing else moves") {
  Hands hands;
  const Scene three = slabs({"a", "b", "c"});
  hands.load(three);
  ui::TransformTool& tool = hands.grab(0);
  SECTION("it is deleted") {
    hands.removePart(0);
    CHECK_FALSE(tool.isDragging());
    const Scene left = hands.scene();
    tool.hover(hands.viewport(), {QPointF(500, 100), Qt::NoButton, Qt::NoModifier});
    tool.cancel(hands.viewport());
    CHECK(hands.scene() == left);
    CHECK(left.parts[0].worldFromPart == three.parts[1].worldFromPart);
  }
  SECTION("another scene comes") {
    const Scene other = slabs({"a", "d"});
    hands.load(other);
    CHECK_FALSE(tool.isDragging());
    tool.hover(hands.viewport(), {QPointF(500, 100), Qt::NoButton, Qt::NoModifier});
    CHECK(hands.scene() == other);
  }
  SECTION("the move is undone") {
    tool.hover(hands.viewport(), {QPointF(500, 100), Qt::NoButton, Qt::NoModifier});
    REQUIRE(hands.scene() != three);
    hands.document().undoStack().undo();
    CHECK_FALSE(tool.isDragging());
    CHECK(hands.scene() == three);
  }
  SECTION("another part goes, and it stays in the hand") {
    hands.removePart(2);
    CHECK(tool.isDragging());
    tool.hover(hands.viewport(), {QPointF(500, 100), Qt::NoButton, Qt::NoModifier});
    CHECK(hands.scene().parts[0].worldFromPart != three.parts[0].worldFromPart);
    CHECK(hands.scene().parts[1].worldFromPart == three.parts[1].worldFromPart);
  }
}

TEST_CASE("What is selected stays so where edits move it in its list, and is dropped where it goes") {
  Hands hands;
  hands.load(slabs({"a", "b", "c"}));
  const auto selected = [&] { return ui::nameOf(hands.scene(), hands.session.selection().current()); };
  hands.selectPart(1);
  hands.removePart(0);
  CHECK(selected() == "b");
  hands.document().undoStack().undo();
  CHECK(selected() == "b");
  hands.document().edit("Rename", [](Scene& scene) { ui::rename(scene, {ui::ItemKind::part, 1}, "z"); });
  CHECK(selected() == "z");
  hands.removePart(1);
  CHECK(hands.session.selection().items().empty());
}

TEST_CASE("A number that is being typed is not given to another part") {
  Hands hands;
  hands.load(slabs({"a", "b"}));
  hands.raise("properties");
  hands.selectPart(0);
  const auto typing = [&]() -> QLineEdit& {
    auto* field = hands.window.findChild<ui::NumberField*>(".velocity");
    if (field == nullptr) {
      for (auto* found : hands.window.findChildren<ui::NumberField*>())
        if (found->isVisible()) field = found;
    }
    REQUIRE(field != nullptr);
    field->beginEditing();
    auto* editor = field->findChild<QLineEdit*>("number-editor");
    REQUIRE(editor != nullptr);
    editor->setText("7");
    return *editor;
  };
  typing();
  const modeling::Part other = hands.scene().parts[1];
  SECTION("it is deleted") {
    hands.removePart(0);
    QTest::qWait(50);
    REQUIRE(hands.scene().parts.size() == 1);
    CHECK(hands.scene().parts[0] == other);
  }
  SECTION("another scene comes") {
    const Scene next = slabs({"b", "a"});
    hands.load(next);
    QTest::qWait(50);
    CHECK(hands.scene() == next);
  }
  SECTION("something else is selected, which takes the number first") {
    const Scene before = hands.scene();
    hands.selectPart(1);
    CHECK(hands.scene() != before);
    CHECK(hands.scene().parts[1] == other);
  }
}

TEST_CASE("A name that is being typed in the outliner is not given to another part") {
  Hands hands;
  hands.load(slabs({"a", "b", "c"}));
  auto& tree = *hands.window.findChild<ui::OutlinerTree*>();
  hands.selectPart(1);
  hands.window.activateWindow();
  tree.setFocus();
  tree.editItem(tree.rowOf({ui::ItemKind::part, 1}), ui::OutlinerTree::nameColumn);
  auto* editor = tree.viewport()->findChild<QLineEdit*>();
  REQUIRE(editor != nullptr);
  editor->setText("mine");
  hands.removePart(0);
  QTest::qWait(20);
  if (auto* still = tree.viewport()->findChild<QLineEdit*>()) QTest::keyClick(still, Qt::Key_Return);
  CHECK(ui::namesOf(hands.scene(), ui::ItemKind::part) == std::vector<std::string>{"b", "c"});
}

TEST_CASE("A gluing that goes while it is edited is not followed by another") {
  Hands hands;
  Scene scene = ui::newScene();
  const ui::Item cup = ui::addThing(scene, ui::newThing("cup"), {});
  ui::addThing(scene, ui::newThing("handle"), {cup});
  ui::addThing(scene, ui::newThing("spout"), {cup});
  REQUIRE(scene.glue.size() == 2);
  hands.load(scene);
  auto& editing = *hands.window.findChild<ui::GlueEditing*>();
  editing.edit(0);
  hands.document().edit("Delete", [](Scene& edited) { edited.glue.erase(edited.glue.begin()); });
  CHECK(editing.stage() == ui::GlueEditing::Stage::off);
  const double reach = hands.scene().glue[0].reach;
  editing.setReach(3.0 * reach, true);
  CHECK(hands.scene().glue[0].reach == reach);
}

TEST_CASE("A profile that is undone while it is dragged is let go") {
  Hands hands;
  Scene scene = ui::newScene();
  ui::addThing(scene, ui::newThing("cup"), {});
  hands.load(scene);
  hands.selectPart(0);
  hands.raise("profile");
  auto& canvas = *hands.window.findChild<ui::ProfileCanvas*>();
  REQUIRE(becomesTrue([&] { return canvas.model().has_value() && canvas.isVisible(); }));
  QTest::qWait(50);
  canvas.frame();
  const QPoint at = canvas.view().toPixel(canvas.model()->position({ui::ProfileSide::outside, 3})).toPoint();
  QTest::mousePress(&canvas, Qt::LeftButton, {}, at);
  QMouseEvent move(QEvent::MouseMove, at + QPoint(30, 0), canvas.mapToGlobal(QPointF(at + QPoint(30, 0))),
                   Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&canvas, &move);
  REQUIRE(hands.scene() != scene);
  hands.document().undoStack().undo();
  REQUIRE(hands.scene() == scene);
  QMouseEvent more(QEvent::MouseMove, at + QPoint(60, 0), canvas.mapToGlobal(QPointF(at + QPoint(60, 0))),
                   Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&canvas, &more);
  CHECK(hands.scene() == scene);
  QTest::mouseRelease(&canvas, Qt::LeftButton, {}, at);
}

TEST_CASE("The pre-flight goes with its scene, and says where it was edited since") {
  Hands hands;
  hands.load(slabs({"a", "b"}));
  auto& dialog = *hands.window.findChild<ui::PreflightDialog*>();
  dialog.show();
  dialog.look();
  REQUIRE(becomesTrue([&] { return dialog.isDone(); }));
  hands.document().edit("Heavier", [](Scene& scene) { scene.environment.gravity.z() = -500.0; });
  bool says = false;
  for (const QLabel* label : dialog.findChildren<QLabel*>()) says |= label->text().contains("look again");
  CHECK(says);
  hands.load(slabs({"c"}));
  CHECK_FALSE(dialog.isVisible());
}

TEST_CASE("A grab by its key can be typed into, whichever panel had the keyboard") {
  Hands hands;
  const Scene scene = slabs({"a"});
  hands.load(scene);
  hands.clickOutliner();
  hands.pointAtViewport();
  for (const char* key : {"G", "Z", "1", "0", "Return"}) hands.pressKey(key);
  CHECK(hands.scene().parts[0].worldFromPart.position.z() ==
        Approx(scene.parts[0].worldFromPart.position.z() + 10.0));
  // Who clicks elsewhere meanwhile is done.
  hands.pointAtViewport();
  hands.pressKey("G");
  auto* tool = dynamic_cast<ui::TransformTool*>(hands.viewport().tool());
  REQUIRE(tool != nullptr);
  REQUIRE(tool->isDragging());
  hands.clickOutliner();
  CHECK_FALSE(tool->isDragging());
}

TEST_CASE("Esc ends the tool in the viewport, whichever panel has the keyboard") {
  Hands hands;
  hands.load(slabs({"a"}));
  hands.raise("live");
  hands.pressKey("Shift+K");
  REQUIRE(dynamic_cast<ui::TouchTool*>(hands.viewport().tool()) != nullptr);
  hands.clickOutliner();
  hands.pressKey("Escape");
  CHECK(hands.viewport().tool() == nullptr);
}

TEST_CASE("Tab over the picture edits the points of what was clicked in the outliner") {
  Hands hands;
  Scene scene = ui::newScene();
  ui::addThing(scene, ui::newThing("handle"), {});
  hands.load(scene);
  hands.clickOutliner();
  hands.pointAtViewport();
  hands.pressKey("Tab");
  CHECK(dynamic_cast<ui::PointsTool*>(hands.viewport().tool()) != nullptr);
  CHECK(hands.viewport().hasFocus());
}

}  // namespace
