// What forms made from lists of fields show and change.
#include <QLineEdit>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <catch2/catch.hpp>

#include "modeling/scene/field_info.h"
#include "sim/methods/method_names.h"
#include "ui/document/new_scene.h"
#include "ui/panels/field_rows.h"
#include "ui/panels/file_field.h"
#include "ui/panels/interval_field.h"
#include "ui/panels/number_field.h"
#include "ui/panels/plain_fields.h"
#include "ui/panels/properties.h"
#include "ui/panels/property_form.h"
#include "ui/session/session.h"

using namespace ui;

namespace {

/// The properties of one thing.
struct Panel {
  QTemporaryDir folder;
  Session session{std::filesystem::path(folder.path().toStdString())};
  Properties properties{session};

  explicit Panel(const modeling::Scene& scene) {
    session.document().reset(scene, {}, folder.path().toStdString());
    properties.resize(320, 800);
    properties.show();
    REQUIRE(QTest::qWaitForWindowExposed(&properties));
  }

  const modeling::Scene& scene() { return session.document().scene(); }
  void select(ItemKind kind) { session.selection().select({kind, 0}); }
  template <class Field>
  Field* field(const char* path) {
    auto* found = properties.form()->findChild<Field*>(QString::fromLatin1(path));
    REQUIRE(found);
    return found;
  }
  void type(NumberField& number, const char* text) {
    number.beginEditing();
    // Editors that are closed live on until the event loop comes round.
    const auto editors = number.findChildren<QLineEdit*>();
    const auto editor = std::ranges::find_if(editors, [](const QLineEdit* one) { return one->isVisible(); });
    REQUIRE(editor != editors.end());
    (*editor)->setText(QString::fromUtf8(text));
    QTest::keyClick(*editor, Qt::Key_Return);
  }
  void choose(const char* path, const char* label) {
    auto* choice = field<ChoiceField>(path);
    const int index = choice->findText(QString::fromLatin1(label));
    REQUIRE(index >= 0);
    choice->setCurrentIndex(index);
    emit choice->activated(index);
  }
  void click(const char* path) { field<CheckField>(path)->click(); }
  bool isShown(const char* path) { return field<QWidget>(path)->isVisibleTo(&properties); }
};

modeling::Scene withMeshes() {
  modeling::Scene scene;
  modeling::MeshShape vase;
  vase.file = "vase.obj";
  modeling::Part part;
  part.name = "vase";
  part.shape = vase;
  scene.parts.push_back(part);
  modeling::MeshObstacle dish;
  dish.file = "dish.stl";
  modeling::SceneCollider collider;
  collider.name = "dish";
  collider.form = dish;
  scene.environment.colliders.push_back(collider);
  return scene;
}

}  // namespace

TEST_CASE("Unit, up axis, thickness and file of meshes are in the window", "[forms]") {
  Panel panel(withMeshes());
  SECTION("of a part") {
    panel.select(ItemKind::part);
    const auto shape = [&] { return std::get<modeling::MeshShape>(panel.scene().parts[0].shape); };
    panel.choose(".unit", "Inch");
    CHECK(shape().unit == modeling::MeshUnit::inch);
    panel.choose(".up", "y");
    CHECK(shape().up == modeling::MeshUp::y);
    emit panel.field<FileField>(".file")->edited(QStringLiteral("bowl.ply"));
    CHECK(shape().file == "bowl.ply");
    CHECK(panel.field<FileField>(".file")->findChild<TextField*>()->text() == "bowl.ply");
  }
  SECTION("of a collider") {
    panel.select(ItemKind::collider);
    const auto form = [&] {
      return std::get<modeling::MeshObstacle>(panel.scene().environment.colliders[0].form);
    };
    panel.choose(".unit", "Millimetre");
    CHECK(form().unit == modeling::MeshUnit::millimetre);
    panel.type(*panel.field<NumberField>(".thickness"), "2 mm");
    CHECK(form().thickness == Approx(0.2));
    CHECK(panel.field<FileField>(".file")->findChild<QToolButton*>(QStringLiteral("choose-file")));
  }
}

TEST_CASE("When a collider is there is given by two times, or by none", "[forms]") {
  Panel panel(withMeshes());
  panel.select(ItemKind::collider);
  const auto active = [&] { return panel.scene().environment.colliders[0].active; };
  auto* field = panel.field<IntervalField>(".active");
  panel.type(field->from(), "0.5");
  REQUIRE(active());
  CHECK((*active())[0] == 0.5);
  CHECK((*active())[1] > 0.5);
  panel.type(field->until(), "800 ms");
  CHECK(active() == std::array<double, 2>{0.5, 0.8});
  CHECK(field->until().value() == 0.8);
  panel.type(field->from(), "");
  CHECK_FALSE(active());
  CHECK_FALSE(field->until().value());
  panel.session.document().undoStack().undo();
  CHECK(active() == std::array<double, 2>{0.5, 0.8});
}

TEST_CASE("A row is shown where its value counts", "[forms]") {
  modeling::Scene scene;
  modeling::Part part;
  part.name = "handle";
  part.shape = modeling::CurvedCylinderShape{};
  scene.parts.push_back(part);
  Panel panel(scene);
  panel.select(ItemKind::part);
  CHECK_FALSE(panel.isShown(".wallThickness"));
  CHECK_FALSE(panel.isShown(".endAngle"));
  panel.choose(".section", "Ring");
  CHECK(panel.isShown(".wallThickness"));
  CHECK_FALSE(panel.isShown(".endAngle"));
  panel.choose(".section", "Arc");
  CHECK(panel.isShown(".endAngle"));
}

TEST_CASE("A group that may be absent is given and taken away by a box to be ticked", "[forms]") {
  Panel panel(withMeshes());
  CHECK_FALSE(panel.isShown(".view.camera.fieldOfView"));
  panel.click(".view.camera");
  REQUIRE(panel.scene().view.camera);
  CHECK(*panel.scene().view.camera == modeling::Camera{});
  panel.click(".view.camera");
  CHECK_FALSE(panel.scene().view.camera);
}

TEST_CASE("A colour that is the kind's own is given and taken back", "[forms]") {
  Panel panel(withMeshes());
  panel.choose(".view.picture.ground.kind", "Checker");
  const auto colour = [&] { return panel.scene().view.picture.ground.colour; };
  auto* field = panel.field<ColourField>(".view.picture.ground.colour");
  CHECK_FALSE(field->value().isValid());
  emit field->edited(QColor(255, 0, 0), true);
  REQUIRE(colour());
  CHECK((*colour())[0] == Approx(1.0));
  CHECK(field->value() == QColor(255, 0, 0));
  emit field->edited(QColor(), true);
  CHECK_FALSE(colour());
}

TEST_CASE("A choice is shown and set by its value, whatever the order of the menu", "[forms]") {
  Panel panel(newScene());
  const auto* info = modeling::findField(modeling::fieldsOf<modeling::Solver>(), "method");
  REQUIRE(info);
  for (const modeling::ChoiceInfo& choice : std::get<modeling::ChoiceAccess>(info->access).choices()) {
    panel.choose(".solver.method", std::string(choice.label).c_str());
    CHECK(static_cast<int>(panel.scene().solver.method) == choice.value);
    CHECK(sim::nameOf(panel.scene().solver.method) == choice.name);
  }
}
