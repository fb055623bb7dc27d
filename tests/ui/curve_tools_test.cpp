#include <QTemporaryDir>
#include <QTest>

#include <catch2/catch.hpp>

#include "ui/editors/editor_actions.h"
#include "ui/editors/points_tool.h"
#include "ui/kinds/bezier_edit.h"
#include "ui/viewport/viewport.h"

using namespace ui;
using modeling::Vec3;

namespace {

modeling::Scene sceneOf(modeling::PartShape shape) {
  modeling::Scene scene;
  modeling::SceneMaterial material;
  material.name = material.values.name = "clay";
  scene.materials.push_back(material);
  modeling::Part part;
  part.name = "part";
  part.material = "clay";
  part.shape = std::move(shape);
  part.worldFromPart.position = Vec3(1.0, 2.0, 3.0);
  part.worldFromPart.rotation.value = Vec3(0.0, 30.0, 0.0);
  scene.parts.push_back(part);
  return scene;
}

modeling::CurvedCylinderShape handle() {
  modeling::CurvedCylinderShape shape;
  shape.curve = {{Vec3(0, 0, 0), Vec3(2, 0, 1), Vec3(3, 0, 1), Vec3(4, 0, 0)},
                 {Vec3(4, 0, 0), Vec3(5, 0, -1), Vec3(6, 0, -3), Vec3(6, 0, -5)}};
  return shape;
}

modeling::BezierPatchShape patch() {
  modeling::BezierPatchShape shape;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) shape.net[i][j] = Vec3(2.0 * double(i), 2.0 * double(j), 0.0);
  return shape;
}

/// Tools work on what is seen; the camera looks down so that the plane of the picture is known.
struct Fixture {
  QTemporaryDir folder;
  Session session{std::filesystem::path(folder.path().toStdString())};
  Viewport viewport{session};
  EditorActions actions{session, viewport, &viewport};

  explicit Fixture(modeling::PartShape shape) {
    session.document().reset(sceneOf(std::move(shape)), {});
    session.selection().select({ItemKind::part, 0});
    viewport.resize(320, 240);
    viewport.show();
    REQUIRE(QTest::qWaitForWindowExposed(&viewport));
    viewport.camera().look(Vec3(3.0, 2.0, 2.0), 30.0, -1.2, 0.5);
  }
  const modeling::Part& part() { return session.document().scene().parts[0]; }
  Vec3 world(std::size_t point) {
    return part().worldFromPart.worldFromPart() * pointsOf(part().shape)->points[point].at;
  }
  PointsTool& tool() {
    auto* tool = dynamic_cast<PointsTool*>(viewport.tool());
    REQUIRE(tool != nullptr);
    return *tool;
  }
  void drag(std::size_t point, const QPointF& by, Qt::KeyboardModifiers modifiers = {}) {
    const auto from = viewport.project(world(point));
    REQUIRE(from);
    REQUIRE(tool().press(viewport, {*from, Qt::LeftButton, {}}));
    for (const double share : {0.3, 0.7, 1.0})
      tool().move(viewport, {*from + share * by, Qt::LeftButton, modifiers});
    tool().release(viewport, {*from + by, Qt::NoButton, modifiers});
  }
  void requireUndoable(const modeling::Scene& before) {
    Document& document = session.document();
    const modeling::Scene after = document.scene();
    CHECK(after != before);
    document.undoStack().undo();
    CHECK(document.scene() == before);
    document.undoStack().redo();
    CHECK(document.scene() == after);
    document.undoStack().undo();
  }
};

}  // namespace

TEST_CASE("Tab edits the points of the selected part and ends it", "[points]") {
  Fixture fixture(patch());
  CHECK(fixture.actions.editPoints()->isEnabled());
  fixture.actions.editPoints()->trigger();
  CHECK(fixture.tool().part() == "part");
  CHECK(fixture.actions.editPoints()->isChecked());
  fixture.actions.editPoints()->trigger();
  CHECK(fixture.viewport.tool() == nullptr);
  CHECK_FALSE(fixture.actions.editPoints()->isChecked());
}

TEST_CASE("Every control point of a patch is dragged in the plane of the picture", "[points]") {
  Fixture fixture(patch());
  fixture.actions.editPoints()->trigger();
  for (std::size_t point = 0; point < 16; ++point) {
    CAPTURE(point);
    const modeling::Scene before = fixture.session.document().scene();
    const Vec3 from = fixture.world(point);
    const QPointF pixel = *fixture.viewport.project(from);
    fixture.drag(point, {12.0, -7.0});
    const Vec3 to = fixture.world(point);
    const QPointF moved = *fixture.viewport.project(to) - pixel;
    CHECK(moved.x() == Approx(12.0).margin(0.01));
    CHECK(moved.y() == Approx(-7.0).margin(0.01));
    CHECK(std::abs((to - from).dot(fixture.viewport.camera().forward())) < 1e-9);
    fixture.requireUndoable(before);
  }
}

TEST_CASE("X, Y and Z keep a dragged point to an axis of the world", "[points]") {
  Fixture fixture(patch());
  fixture.actions.editPoints()->trigger();
  for (const Eigen::Index axis : {0, 1, 2}) {
    const modeling::Scene before = fixture.session.document().scene();
    const Vec3 from = fixture.world(5);
    CHECK(fixture.tool().key(fixture.viewport, Qt::Key_X + int(axis), {}));
    fixture.drag(5, {25.0, 15.0});
    Vec3 by = fixture.world(5) - from;
    CHECK(std::abs(by[axis]) > 1e-3);
    by[axis] = 0.0;
    CHECK(by.norm() < 1e-9);
    fixture.requireUndoable(before);
  }
}

TEST_CASE("A patch with two nets has thirty-two points", "[points]") {
  modeling::BezierPatchShape shape = patch();
  shape.oppositeNet = shape.net;
  for (auto& row : *shape.oppositeNet)
    for (Vec3& point : row) point.z() += 1.0;
  Fixture fixture(shape);
  CHECK(pointsOf(fixture.part().shape)->points.size() == 32);
  fixture.actions.editPoints()->trigger();
  const modeling::Scene before = fixture.session.document().scene();
  fixture.drag(20, {10.0, 0.0});
  CHECK(std::get<modeling::BezierPatchShape>(fixture.part().shape).net == shape.net);
  fixture.requireUndoable(before);
}

TEST_CASE("A curve's point takes its handles along, and smooth handles stay in line", "[points]") {
  Fixture fixture(handle());
  fixture.actions.editPoints()->trigger();
  const modeling::Scene before = fixture.session.document().scene();
  const Vec3 point = fixture.world(3);
  const Vec3 before2 = fixture.world(2);
  fixture.drag(3, {15.0, 5.0});
  CHECK((fixture.world(2) - before2 - (fixture.world(3) - point)).norm() < 1e-9);
  fixture.requireUndoable(before);
  fixture.drag(4, {10.0, 20.0});
  const Vec3 out = (fixture.world(4) - fixture.world(3)).normalized();
  const Vec3 in = (fixture.world(2) - fixture.world(3)).normalized();
  CHECK(out.dot(in) == Approx(-1.0));
  fixture.requireUndoable(before);
  fixture.drag(4, {10.0, 20.0}, Qt::AltModifier);
  CHECK((fixture.world(2) - before2).norm() < 1e-9);
  fixture.requireUndoable(before);
}

TEST_CASE("A section's size is dragged by its handle", "[points]") {
  Fixture fixture(handle());
  const auto points = pointsOf(fixture.part().shape)->points;
  const auto width = std::find_if(points.begin(), points.end(), [](const ShapePoint& point) {
    return point.kind == ShapePointKind::width;
  });
  REQUIRE(width != points.end());
  const auto index = static_cast<std::size_t>(width - points.begin());
  modeling::PartShape shape = fixture.part().shape;
  const Vec3 outwards = (width->at - handle().curve[0][0]).normalized();
  movePoints(shape, {index}, 0.25 * outwards);
  for (const double value : std::get<modeling::CurvedCylinderShape>(shape).halfWidth[0])
    CHECK(value == Approx(0.75));
  movePoints(shape, {index}, 0.25 * outwards, true);
  const auto& tapered = std::get<modeling::CurvedCylinderShape>(shape).halfWidth[0];
  CHECK(tapered[0] == Approx(1.0));
  CHECK(tapered[3] == Approx(0.75));
  movePoints(shape, {index}, -50.0 * outwards, true);
  CHECK(std::get<modeling::CurvedCylinderShape>(shape).halfWidth[0][0] > 0.0);
}

TEST_CASE("Cancelling a drag of points leaves the scene as it was", "[points]") {
  Fixture fixture(handle());
  fixture.actions.editPoints()->trigger();
  const modeling::Scene before = fixture.session.document().scene();
  const QPointF from = *fixture.viewport.project(fixture.world(6));
  fixture.tool().press(fixture.viewport, {from, Qt::LeftButton, {}});
  fixture.tool().move(fixture.viewport, {from + QPointF(30, 0), Qt::LeftButton, {}});
  CHECK(fixture.session.document().scene() != before);
  CHECK(fixture.tool().cancel(fixture.viewport));
  CHECK(fixture.session.document().scene() == before);
  CHECK_FALSE(fixture.session.document().undoStack().canUndo());
}

TEST_CASE("Ctrl and a click on a curve adds a point that leaves it as it is, Delete takes it away",
          "[points]") {
  modeling::CurvedCylinderShape shape = handle();
  shape.halfWidth = {{0.3, 0.4, 0.5, 0.6}, {0.6, 0.6, 0.6, 0.6}};
  Fixture fixture(shape);
  fixture.actions.editPoints()->trigger();
  const modeling::Scene before = fixture.session.document().scene();
  const Vec3 middle = modeling::evaluate(shape.curve[0], 0.5);
  const Vec3 seen = fixture.part().worldFromPart.worldFromPart() * middle;
  const QPointF pixel = *fixture.viewport.project(seen);
  REQUIRE(fixture.tool().press(fixture.viewport, {pixel, Qt::LeftButton, Qt::ControlModifier}));
  const auto& cut = std::get<modeling::CurvedCylinderShape>(fixture.part().shape);
  REQUIRE(cut.curve.size() == 3);
  CHECK(cut.halfWidth.size() == 3);
  CHECK(cut.halfDepth == shape.halfDepth);
  CHECK(fixture.tool().selected() == std::set<std::size_t>{3});
  for (const double t : {0.1, 0.4, 0.8}) {
    const double split = 0.5;
    const Vec3 expected = modeling::evaluate(shape.curve[0], t);
    const Vec3 found = t < split ? modeling::evaluate(cut.curve[0], t / split)
                                 : modeling::evaluate(cut.curve[1], (t - split) / (1.0 - split));
    // The click is a pixel, not a number.
    CHECK((expected - found).norm() < 0.1);
  }
  fixture.requireUndoable(before);
  fixture.session.document().undoStack().redo();
  REQUIRE(fixture.tool().key(fixture.viewport, Qt::Key_Delete, {}));
  CHECK(std::get<modeling::CurvedCylinderShape>(fixture.part().shape).curve.size() == 2);
  CHECK(std::get<modeling::CurvedCylinderShape>(fixture.part().shape).halfWidth.size() == 2);
}

TEST_CASE("Deleting points shortens a curve from its ends, and two of them stay", "[points]") {
  modeling::PartShape shape = handle();
  const auto curve = [&]() -> const modeling::CurveChain& {
    return std::get<modeling::CurvedCylinderShape>(shape).curve;
  };
  CHECK_FALSE(removePoints(shape, {1, 2}));
  REQUIRE(removePoints(shape, {0}));
  CHECK(curve() == modeling::CurveChain{handle().curve[1]});
  CHECK_FALSE(removePoints(shape, {0, 3}));
  shape = handle();
  REQUIRE(removePoints(shape, {6}));
  CHECK(curve() == modeling::CurveChain{handle().curve[0]});
  shape = handle();
  REQUIRE(removePoints(shape, {3}));
  REQUIRE(curve().size() == 1);
  CHECK(curve()[0][0] == handle().curve[0][0]);
  CHECK(curve()[0][1] == handle().curve[0][1]);
  CHECK(curve()[0][2] == handle().curve[1][2]);
  CHECK(curve()[0][3] == handle().curve[1][3]);
}
