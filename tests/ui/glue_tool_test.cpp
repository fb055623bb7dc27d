#include "ui/editors/glue_tool.h"

#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>

#include <catch2/catch.hpp>

#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "ui/editors/glue_panel.h"
#include "ui/viewport/viewport.h"

using namespace ui;
using modeling::Vec3;

namespace {

modeling::Part slab(const std::string& name, const Vec3& position) {
  modeling::Part part;
  part.name = name;
  part.material = "clay";
  part.shape = modeling::SlabShape{Vec3(3.0, 3.0, 1.0), {1.0, {}}};
  part.worldFromPart.position = position;
  return part;
}

/// Two slabs, one above the other, a tenth of a millimetre to several apart.
modeling::Scene twoSlabs(double gap) {
  modeling::Scene scene;
  modeling::SceneMaterial material;
  material.name = material.values.name = "clay";
  scene.materials.push_back(material);
  scene.parts.push_back(slab("lower", Vec3::Zero()));
  scene.parts.push_back(slab("upper", Vec3(0.1, 0.0, 1.0 + gap)));
  return scene;
}

struct Fixture {
  QTemporaryDir folder;
  Session session{std::filesystem::path(folder.path().toStdString())};
  GlueEditing editing{session};
  QWidget window;
  GluePanel* panel = nullptr;

  explicit Fixture(const modeling::Scene& scene) {
    session.document().reset(scene, {});
    window.resize(480, 360);
    panel = new GluePanel(editing, &window);
    window.show();
    REQUIRE(QTest::qWaitForWindowExposed(&window));
  }
  void settle() {
    REQUIRE(QTest::qWaitFor(
        [&] {
          return editing.outcome() && !editing.isBusy() && editing.outcome()->gluing == editing.gluing();
        },
        60000));
  }
  template <class Widget>
  Widget& find(const char* name) {
    auto* widget = panel->findChild<Widget*>(QString::fromLatin1(name));
    REQUIRE(widget != nullptr);
    return *widget;
  }
  std::size_t glued() {
    const auto built = modeling::build(session.document().scene(), {});
    if (!built) FAIL(built.problem().line());
    return built->glue.back().nodesMerged;
  }
};

}  // namespace

TEST_CASE("The pairs shown are those that build() glues", "[glue]") {
  const std::filesystem::path scenes = std::filesystem::path(SMITHEREENS_SOURCE_DIR) / "resources" / "scenes";
  for (const char* name : {"teapot-drop", "cup-roll"}) {
    CAPTURE(name);
    const auto file = modeling::loadScene(scenes / (std::string(name) + ".scene.json"));
    REQUIRE(file);
    const auto built = modeling::build(file->scene, scenes);
    REQUIRE(built);
    GluePreviewer previewer;
    for (std::size_t i = 0; i < file->scene.glue.size(); ++i) {
      const GlueOutcome outcome = previewer.outcome(file->scene, i, scenes);
      CAPTURE(i);
      REQUIRE_FALSE(outcome.problem);
      CHECK(outcome.links.size() == built->glue[i].nodesMerged);
      CHECK(outcome.report.worstDistance == built->glue[i].worstDistance);
      CHECK(outcome.report.nodesReleased == built->glue[i].nodesReleased);
      CHECK(outcome.report.cellsDropped == built->glue[i].cellsDropped);
    }
  }
}

TEST_CASE("With one part selected its only gluing is shown, else one is asked for", "[glue]") {
  modeling::Scene scene = twoSlabs(0.1);
  scene.glue.push_back({"upper", "lower", 0.5, {}, {}, {}});
  Fixture fixture(scene);
  fixture.session.selection().select({ItemKind::part, 1});
  fixture.editing.begin();
  CHECK(fixture.editing.stage() == GlueEditing::Stage::adjust);
  CHECK(fixture.editing.isExisting());
  fixture.session.document().edit("Unglue", [](modeling::Scene& edited) { edited.glue.clear(); });
  fixture.editing.begin();
  CHECK(fixture.editing.stage() == GlueEditing::Stage::chooseA);
}

TEST_CASE("Two parts are picked, seen and glued; the glue is one step", "[glue]") {
  Fixture fixture(twoSlabs(0.2));
  fixture.editing.begin();
  CHECK(fixture.editing.stage() == GlueEditing::Stage::chooseA);
  CHECK(fixture.panel->isVisible());
  fixture.editing.choose("upper");
  fixture.editing.choose("upper");
  CHECK(fixture.editing.stage() == GlueEditing::Stage::chooseB);
  fixture.editing.choose("lower");
  fixture.settle();
  CHECK(fixture.editing.outcome()->links.size() == 16);
  CHECK(fixture.find<QLabel>("glue-counts").text().contains(QStringLiteral("16")));
  const modeling::Scene before = fixture.session.document().scene();
  QTest::mouseClick(&fixture.find<QPushButton>("glue-glue"), Qt::LeftButton);
  REQUIRE(fixture.session.document().scene().glue.size() == 1);
  CHECK(fixture.glued() == 16);
  CHECK(fixture.editing.isExisting());
  const modeling::Scene after = fixture.session.document().scene();
  fixture.session.document().undoStack().undo();
  CHECK(fixture.session.document().scene() == before);
  CHECK(fixture.editing.stage() == GlueEditing::Stage::off);
  fixture.session.document().undoStack().redo();
  CHECK(fixture.session.document().scene() == after);
}

TEST_CASE("Dragging the reach changes the pairs, and is one step of an existing glue", "[glue]") {
  modeling::Scene scene = twoSlabs(0.2);
  scene.glue.push_back({"upper", "lower", 0.5, {}, {}, {}});
  Fixture fixture(scene);
  fixture.session.selection().select({ItemKind::gluing, 0});
  fixture.editing.begin();
  fixture.settle();
  CHECK(fixture.editing.isExisting());
  auto& slider = fixture.find<QSlider>("glue-reach-slider");
  slider.setSliderDown(true);
  for (int step = 0; step < 5; ++step) slider.setValue(slider.value() - 4);
  slider.setSliderDown(false);
  CHECK(fixture.session.document().undoStack().index() == 1);
  const double reach = fixture.session.document().scene().glue[0].reach;
  CHECK(reach < 0.5);
  fixture.settle();
  CHECK(fixture.editing.outcome()->links.size() == fixture.glued());
  fixture.session.document().undoStack().undo();
  CHECK(fixture.session.document().scene() == scene);
  CHECK(fixture.editing.gluing().reach == 0.5);
}

TEST_CASE("A pair taken out stays out, and can be put back", "[glue]") {
  Fixture fixture(twoSlabs(0.2));
  fixture.editing.begin();
  fixture.editing.choose("upper");
  fixture.editing.choose("lower");
  fixture.settle();
  const modeling::NodeIndex node = fixture.editing.outcome()->links[3].a;
  fixture.editing.toggle(node);
  fixture.settle();
  CHECK(fixture.editing.outcome()->links.size() == 15);
  REQUIRE(fixture.editing.outcome()->freed.size() == 1);
  CHECK(fixture.editing.outcome()->freed[0].a == node);
  fixture.editing.glue();
  CHECK(fixture.session.document().scene().glue[0].exclude == std::vector<modeling::NodeIndex>{node});
  CHECK(fixture.glued() == 15);
  fixture.editing.toggle(node);
  fixture.settle();
  CHECK(fixture.glued() == 16);
}

TEST_CASE("Where nothing is in reach, the distance that would do is offered", "[glue]") {
  Fixture fixture(twoSlabs(2.0));
  fixture.editing.begin();
  fixture.editing.choose("upper");
  fixture.editing.choose("lower");
  fixture.settle();
  REQUIRE(fixture.editing.outcome()->problem);
  REQUIRE(fixture.editing.outcome()->nearest);
  CHECK(fixture.editing.outcome()->nearest->distance() == Approx(std::hypot(2.0, 0.1)));
  CHECK_FALSE(fixture.find<QPushButton>("glue-glue").isEnabled());
  CHECK(fixture.find<QLabel>("glue-problem").text().contains(QStringLiteral("reach")));
  QTest::mouseClick(&fixture.find<QPushButton>("glue-use-nearest"), Qt::LeftButton);
  fixture.settle();
  CHECK_FALSE(fixture.editing.outcome()->problem);
  CHECK(fixture.find<QPushButton>("glue-glue").isEnabled());
}

TEST_CASE("A glue follows when a part moves", "[glue]") {
  modeling::Scene scene = twoSlabs(0.2);
  scene.glue.push_back({"upper", "lower", 0.5, {}, {}, {}});
  Fixture fixture(scene);
  fixture.editing.edit(0);
  fixture.settle();
  CHECK(fixture.editing.outcome()->links.size() == 16);
  fixture.session.document().edit(QStringLiteral("move"), [](modeling::Scene& edited) {
    edited.parts[1].worldFromPart.position.x() += 1.0;
  });
  REQUIRE(QTest::qWaitFor(
      [&] { return !fixture.editing.isBusy() && fixture.editing.outcome()->links.size() == 12; }, 60000));
  CHECK(fixture.glued() == 12);
}

TEST_CASE("Parts that are glued already are not glued again, but edited", "[glue]") {
  modeling::Scene scene = twoSlabs(0.2);
  scene.glue.push_back({"upper", "lower", 0.4, {}, {}, {}});
  Fixture fixture(scene);
  fixture.session.selection().set({{ItemKind::part, 0}, {ItemKind::part, 1}});
  fixture.editing.begin();
  CHECK(fixture.editing.isExisting());
  CHECK(fixture.editing.gluing().reach == 0.4);
}

TEST_CASE("A box dragged round some lines keeps the glue to those, until it is wanted everywhere", "[glue]") {
  modeling::Scene scene = twoSlabs(0.2);
  scene.glue.push_back({"upper", "lower", 0.5, {}, {}, {}});
  Fixture fixture(scene);
  Viewport viewport(fixture.session);
  viewport.resize(480, 360);
  // From above: the first row of nodes is at the left.
  viewport.camera().look(Vec3(0.0, 0.0, 0.6), 12.0, -1.5707963, 1.5);
  fixture.editing.edit(0);
  fixture.settle();
  GlueTool tool(fixture.session, fixture.editing);
  const QPointF first = *viewport.project(Vec3(-1.9, -2.1, 0.7));
  const QPointF last = *viewport.project(Vec3(-0.9, 2.1, 0.7));
  CHECK(tool.press(viewport, {first, Qt::LeftButton, {}}));
  tool.move(viewport, {last, Qt::LeftButton, {}});
  tool.release(viewport, {last, Qt::NoButton, {}});
  fixture.settle();
  REQUIRE(fixture.session.document().scene().glue[0].region);
  CHECK(fixture.glued() == 4);
  CHECK(fixture.editing.outcome()->links.size() == 4);
  CHECK(fixture.find<QPushButton>("glue-everywhere").isVisible());
  QTest::mouseClick(&fixture.find<QPushButton>("glue-everywhere"), Qt::LeftButton);
  fixture.settle();
  CHECK(fixture.glued() == 16);
  fixture.session.document().undoStack().undo();
  fixture.session.document().undoStack().undo();
  CHECK(fixture.session.document().scene() == scene);
}
