#include <QAction>
#include <QDropEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <catch2/catch.hpp>

#include "ui/document/scene_edits.h"
#include "ui/panels/add_actions.h"
#include "ui/panels/empty_scene.h"
#include "ui/panels/number_field.h"
#include "ui/panels/outliner.h"
#include "ui/panels/outliner_tree.h"
#include "ui/panels/plain_fields.h"
#include "ui/panels/preflight_dialog.h"
#include "ui/panels/properties.h"
#include "ui/panels/property_form.h"
#include "ui/panels/scene_actions.h"
#include "ui/panels/vector_field.h"
#include "ui/session/session.h"

using namespace ui;

namespace {

/// Outliner and properties beside each other, as in the window.
struct Desk {
  QTemporaryDir folder;
  Session session{std::filesystem::path(folder.path().toStdString())};
  QWidget window;
  SceneActions* actions = new SceneActions(session, &window);
  AddActions* adding = new AddActions(session, &window);
  Outliner* outliner = new Outliner(session, *actions, &window);
  Properties* properties = new Properties(session, &window);

  Desk() {
    auto* row = new QHBoxLayout(&window);
    row->addWidget(outliner);
    row->addWidget(properties);
    window.resize(640, 800);
    window.show();
    REQUIRE(QTest::qWaitForWindowExposed(&window));
    window.activateWindow();
    REQUIRE(QTest::qWaitForWindowActive(&window));
  }

  const modeling::Scene& scene() { return session.document().scene(); }
  OutlinerTree& tree() { return outliner->tree(); }
  void add(const char* name) { adding->add(newThing(name)); }
  void addCup() { add("cup"); }
  void select(ItemKind kind, std::size_t index) { session.selection().select({kind, index}); }
  bool builds() {
    return QTest::qWaitFor([&] { return !session.isBuilding() && session.preview()->scene == scene(); },
                           60000);
  }
  QPoint at(const Item& item, int column = 0) {
    QTreeWidgetItem* row = tree().rowOf(item);
    tree().scrollToItem(row);
    return tree().visualRect(tree().indexFromItem(row, column)).center();
  }
  void click(const Item& item, Qt::KeyboardModifiers modifiers = {}, int column = 0) {
    QTest::mouseClick(tree().viewport(), Qt::LeftButton, modifiers, at(item, column));
  }

  NumberField* number(const char* name) {
    return properties->form()->findChild<NumberField*>(QString::fromLatin1(name));
  }
  VectorField* vector(const char* name) {
    return properties->form()->findChild<VectorField*>(QString::fromLatin1(name));
  }
  void type(NumberField* field, const char* text) {
    REQUIRE(field);
    field->beginEditing();
    auto* editor = field->findChild<QLineEdit*>();
    editor->setText(QString::fromUtf8(text));
    QTest::keyClick(editor, Qt::Key_Return);
  }

  /// Undoing all gives the first scene, redoing all the last.
  void checkHistory(const modeling::Scene& first) {
    const modeling::Scene last = scene();
    QUndoStack& stack = session.document().undoStack();
    while (stack.canUndo()) stack.undo();
    CHECK(scene() == first);
    while (stack.canRedo()) stack.redo();
    CHECK(scene() == last);
  }
};

/// A track with one key.
modeling::SceneTrack track(sim::TrackTarget target, const char* object,
                           const std::variant<double, sim::Vec3>& value) {
  modeling::SceneTrackKey key;
  key.value = value;
  modeling::SceneTrack result;
  result.target.target = target;
  result.target.object = object;
  result.keys.push_back(key);
  return result;
}

/// Events of a drag come from the window system only: they are handed in here.
struct DragAccess : OutlinerTree {
  static constexpr void (OutlinerTree::*over)(QDragMoveEvent*) = &DragAccess::dragMoveEvent;
  static constexpr void (OutlinerTree::*drop)(QDropEvent*) = &DragAccess::dropEvent;
};

constexpr Item kFirst{ItemKind::part, 0};
constexpr Item kSecond{ItemKind::part, 1};

}  // namespace

TEST_CASE("A cup is added by one click, selected, and shown in outliner and properties", "[authoring]") {
  Desk desk;
  const modeling::Scene empty = desk.scene();
  EmptyScene start(desk.session, *desk.adding, &desk.window);
  REQUIRE(start.isVisible());
  QTest::mouseClick(start.findChild<QToolButton*>(QStringLiteral("add-cup")), Qt::LeftButton);
  CHECK_FALSE(start.isVisible());
  REQUIRE(desk.scene().parts.size() == 1);
  CHECK(desk.session.selection().current() == kFirst);
  CHECK(desk.tree().rowOf(kFirst)->text(0) == "cup");
  CHECK(desk.tree().rowOf(kFirst)->isSelected());
  CHECK(desk.number(".resolution.cellSize"));
  REQUIRE(desk.builds());
  CHECK(desk.session.preview()->built);
  desk.checkHistory(empty);
}

TEST_CASE("Selection in the outliner and elsewhere is the same", "[authoring]") {
  Desk desk;
  desk.addCup();
  desk.addCup();
  desk.click(kFirst);
  CHECK(desk.session.selection().items() == std::vector<Item>{kFirst});
  desk.click(kSecond, Qt::ControlModifier);
  CHECK(desk.session.selection().items() == std::vector<Item>{kFirst, kSecond});
  desk.session.selection().select({ItemKind::collider, 0});
  CHECK(desk.tree().selectedItems() == QList<QTreeWidgetItem*>{desk.tree().rowOf({ItemKind::collider, 0})});
  desk.session.selection().clear();
  CHECK(desk.tree().selectedItems().isEmpty());
}

TEST_CASE("A part is renamed in the outliner, and its glue follows", "[authoring]") {
  Desk desk;
  desk.addCup();
  desk.add("handle");
  REQUIRE(desk.scene().glue.size() == 1);
  const modeling::Scene before = desk.scene();
  desk.click(kFirst);
  desk.outliner->renameSelected();
  auto* editor = desk.tree().findChild<QLineEdit*>();
  REQUIRE(editor);
  editor->setText(QStringLiteral("mug"));
  QTest::keyClick(editor, Qt::Key_Return);
  QTest::qWait(20);  // the tree takes it when the key has been dealt with
  CHECK(desk.scene().parts[0].name == "mug");
  CHECK(desk.scene().glue[0].b == "mug");
  CHECK(desk.tree().rowOf({ItemKind::gluing, 0})->text(0) == "handle to mug");
  desk.session.document().undoStack().undo();
  CHECK(desk.scene() == before);
}

TEST_CASE("The eye and the lock of a row hide and lock it", "[authoring]") {
  Desk desk;
  desk.addCup();
  desk.addCup();
  desk.click(kFirst);
  desk.click(kSecond, {}, OutlinerTree::eyeColumn);
  CHECK(isHidden(desk.scene(), kSecond));
  CHECK_FALSE(isHidden(desk.scene(), kFirst));
  CHECK(desk.session.selection().items() == std::vector<Item>{kFirst});
  desk.click(kFirst, {}, OutlinerTree::lockColumn);
  CHECK(isLocked(desk.scene(), kFirst));
  desk.actions->showAllAction()->trigger();
  CHECK_FALSE(isHidden(desk.scene(), kSecond));
  desk.checkHistory({});
}

TEST_CASE("What is selected is doubled and deleted by keys", "[authoring]") {
  Desk desk;
  desk.addCup();
  desk.add("handle");
  desk.session.selection().set({kFirst, kSecond});
  QTest::keyClick(&desk.tree(), Qt::Key_D, Qt::ControlModifier);
  CHECK(desk.scene().parts.size() == 4);
  CHECK(desk.scene().glue.size() == 2);
  CHECK(desk.session.selection().items().size() == 2);
  REQUIRE(desk.builds());
  CHECK_FALSE(desk.session.preview()->problem);
  desk.select(ItemKind::part, 0);
  QTest::keyClick(&desk.tree(), Qt::Key_Delete);
  CHECK(desk.scene().parts.size() == 3);
  CHECK(desk.scene().glue.size() == 1);
  CHECK(desk.session.selection().items().empty());
  desk.checkHistory({});
}

TEST_CASE("A scene without a name is called as its file is, and saving it renames nothing", "[authoring]") {
  Desk desk;
  desk.addCup();
  CHECK(desk.tree().rowOf({})->text(0) == "Untitled");
  const modeling::Scene before = desk.scene();
  const auto file = std::filesystem::path(desk.folder.path().toStdString()) / "mug.scene.json";
  REQUIRE(desk.session.document().saveTo(file));
  CHECK(desk.tree().rowOf({})->text(0) == "mug");
  CHECK(desk.scene() == before);
  CHECK_FALSE(desk.session.document().isModified());
}

TEST_CASE("A row that is dragged below another comes after it, as one step", "[authoring]") {
  Desk desk;
  desk.addCup();
  desk.addCup();
  const std::vector<std::string> before{desk.scene().parts[0].name, desk.scene().parts[1].name};
  desk.click(kFirst);
  const auto drop = [&](const Item& onto, int below) {
    OutlinerTree& tree = desk.tree();
    const std::unique_ptr<QMimeData> data(tree.model()->mimeData(tree.selectionModel()->selectedIndexes()));
    const QPoint at = desk.at(onto) + QPoint(0, below);
    QDragMoveEvent over(at, Qt::MoveAction, data.get(), Qt::LeftButton, Qt::NoModifier);
    (tree.*DragAccess::over)(&over);
    QDropEvent event(QPointF(at), Qt::MoveAction, data.get(), Qt::LeftButton, Qt::NoModifier);
    (tree.*DragAccess::drop)(&event);
    return over.isAccepted();
  };
  CHECK(drop(kSecond, 6));
  CHECK(desk.scene().parts[0].name == before[1]);
  CHECK(desk.scene().parts[1].name == before[0]);
  CHECK(desk.session.selection().current() == kSecond);
  CHECK(desk.tree().rowOf(kSecond)->text(0).toStdString() == before[0]);
  // Not among things of another kind.
  CHECK_FALSE(drop({ItemKind::material, 0}, 0));
  CHECK(desk.tree().groupOf(ItemKind::part)->childCount() == 2);
  desk.checkHistory({});
}

TEST_CASE("A material in use is not deleted, and the person is told why", "[authoring]") {
  Desk desk;
  desk.addCup();
  std::string told;
  QObject::connect(&desk.session, &Session::problemFound, &desk.window,
                   [&](const sim::Problem& problem) { told = problem.line(); });
  desk.select(ItemKind::material, 0);
  QTest::keyClick(&desk.tree(), Qt::Key_Delete);
  CHECK(desk.scene().materials.size() == 1);
  CHECK(told.find("cup") != std::string::npos);
  CHECK(told.find("another material") != std::string::npos);
}

TEST_CASE("A number of the properties is typed with a unit and undone", "[authoring]") {
  Desk desk;
  desk.addCup();
  const modeling::Scene before = desk.scene();
  desk.type(desk.number(".resolution.cellSize"), "8 mm");
  CHECK(std::get<modeling::RevolutionShape>(desk.scene().parts[0].shape).resolution.cellSize == Approx(0.8));
  desk.type(&desk.vector(".worldFromPart.position")->field(2), "10 in");
  CHECK(desk.scene().parts[0].worldFromPart.position.z() == Approx(25.4));
  desk.type(&desk.vector(".worldFromPart.rotation")->field(0), "pi/2 rad");
  CHECK(std::get<sim::Vec3>(desk.scene().parts[0].worldFromPart.rotation.value).x() == Approx(90.0));
  desk.type(&desk.vector(".velocity")->field(2), "-6 m/s");
  CHECK(desk.scene().parts[0].velocity.z() == Approx(-600.0));
  QUndoStack& stack = desk.session.document().undoStack();
  for (int i = 0; i < 4; ++i) stack.undo();
  CHECK(desk.scene() == before);
  CHECK(desk.number(".resolution.cellSize")->value() == Approx(0.6));
  while (stack.canRedo()) stack.redo();
  desk.checkHistory({});
}

TEST_CASE("A drag in the properties is one step of the history", "[authoring]") {
  Desk desk;
  desk.addCup();
  const int steps = desk.session.document().undoStack().count();
  NumberField* field = &desk.vector(".worldFromPart.position")->field(2);
  const QPointF start(20, 8);
  QTest::mousePress(field, Qt::LeftButton, {}, start.toPoint());
  for (int x = 1; x <= 30; ++x) {
    const QPointF at = start + QPointF(x, 0);
    QMouseEvent move(QEvent::MouseMove, at, field->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(field, &move);
  }
  QTest::mouseRelease(field, Qt::LeftButton, {}, start.toPoint() + QPoint(30, 0));
  CHECK(desk.scene().parts[0].worldFromPart.position.z() == Approx(2.5));
  CHECK(desk.session.document().undoStack().count() == steps + 1);
  desk.session.document().undoStack().undo();
  CHECK(desk.scene().parts[0].worldFromPart.position.z() == Approx(0.0).margin(1e-12));
}

TEST_CASE("Of several parts an edit changes all, and what differs is left alone", "[authoring]") {
  Desk desk;
  desk.addCup();
  desk.addCup();
  const double x = desk.scene().parts[1].worldFromPart.position.x();
  desk.session.selection().set({kFirst, kSecond});
  desk.type(&desk.vector(".worldFromPart.position")->field(2), "30");
  for (const modeling::Part& part : desk.scene().parts) CHECK(part.worldFromPart.position.z() == 30.0);
  CHECK(desk.scene().parts[0].worldFromPart.position.x() == 0.0);
  CHECK(desk.scene().parts[1].worldFromPart.position.x() == x);
}

TEST_CASE("A problem of the scene stands at the field it belongs to", "[authoring]") {
  Desk desk;
  desk.addCup();
  desk.type(desk.number(".resolution.counts[0]"), "7");
  REQUIRE(desk.builds());
  REQUIRE(desk.session.preview()->problem);
  const auto shown = [&] {
    for (QLabel* label : desk.properties->form()->findChildren<QLabel*>(QStringLiteral("property-problem")))
      if (label->isVisibleTo(desk.properties)) return label->text();
    return QString();
  };
  CHECK(shown().size() > 10);
  desk.session.document().undoStack().undo();
  REQUIRE(desk.builds());
  CHECK(shown().isEmpty());
}

TEST_CASE("Every kind of thing has properties", "[authoring]") {
  Desk desk;
  for (const NewThing& thing : newThings()) desk.adding->add(thing);
  desk.session.document().edit(QStringLiteral("tracks"), [](modeling::Scene& scene) {
    scene.tracks.push_back(track(sim::TrackTarget::gravityScale, "", 2.0));
    scene.tracks.push_back(track(sim::TrackTarget::colliderPosition, "floor", sim::Vec3(0, 0, 0)));
    scene.glue.push_back({"handle", "cup", 1.0, {}, {}, {}});
    scene.materials[0].values.plastic = modeling::Plastic{0.1, 1.0};
  });
  REQUIRE(desk.builds());
  const modeling::Scene before = desk.scene();
  for (const ItemKind kind : {ItemKind::scene, ItemKind::part, ItemKind::gluing, ItemKind::collider,
                              ItemKind::material, ItemKind::track}) {
    for (std::size_t i = 0; i < countOf(before, kind); ++i) {
      INFO(nameOf(before, {kind, i}).toStdString());
      desk.select(kind, i);
      desk.properties->form()->showScene();
      CHECK(desk.properties->form()->findChildren<QWidget*>().size() > 10);
    }
  }
  CHECK(desk.scene() == before);
}

TEST_CASE("A material breaks by one measure at a time, and about as easily by another", "[authoring]") {
  Desk desk;
  desk.addCup();
  desk.select(ItemKind::material, 0);
  const auto material = [&]() -> const modeling::Material& { return desk.scene().materials[0].values; };
  const double strain = modeling::breakStrain(material(), 0.5);
  auto* choice = desk.properties->form()->findChild<ChoiceField*>(QStringLiteral(".threshold"));
  REQUIRE(choice);
  const auto choose = [&](int index) {
    choice = desk.properties->form()->findChild<ChoiceField*>(QStringLiteral(".threshold"));
    choice->setCurrentIndex(index);
    emit choice->activated(index);
  };
  choose(3);
  CHECK(material().fractureToughness);
  CHECK_FALSE(material().threshold.mean);
  CHECK(modeling::breakStrain(material(), 0.5) == Approx(strain));
  choose(2);
  CHECK(material().strength);
  CHECK(modeling::breakStrain(material(), 0.5) == Approx(strain));
  choose(0);
  CHECK_FALSE(std::isfinite(modeling::breakStrain(material(), 0.5)));
  CHECK(modeling::checkScene(desk.scene()).ok());
  desk.checkHistory({});
}

TEST_CASE("Pre-flight says what a run will cost and what breaks by itself", "[authoring]") {
  Desk desk;
  desk.addCup();
  PreflightDialog dialog(desk.session);
  dialog.show();
  dialog.look();
  REQUIRE(QTest::qWaitFor([&] { return dialog.isDone(); }, 60000));
  const auto texts = [&] {
    QString all;
    for (const QLabel* label : dialog.findChildren<QLabel*>()) all += label->text() + u'\n';
    return all;
  };
  CHECK(texts().contains("nodes"));
  CHECK(texts().contains("stable"));
  CHECK(texts().contains("none"));
  desk.session.document().edit(QStringLiteral("step"),
                               [](modeling::Scene& scene) { scene.solver.step.seconds = 1.0; });
  dialog.look();
  REQUIRE(QTest::qWaitFor([&] { return dialog.isDone(); }, 60000));
  CHECK(texts().contains("too long to be stable"));
  auto* parts = dialog.findChild<QTreeWidget*>();
  desk.session.selection().clear();
  emit parts->itemClicked(parts->topLevelItem(0), 0);
  CHECK(desk.session.selection().current() == kFirst);
}
