#include "ui/kinds/part_kinds.h"

#include <QCoreApplication>

#include "ui/kinds/point_handles.h"
#include "ui/kinds/wall_fit.h"

namespace ui {
namespace {

using modeling::Vec3;

QString translated(const char* text) {
  return QCoreApplication::translate("part kinds", text);
}

// One record a kind of part. One that is missing does not compile.

PartKind recordOf(const modeling::SlabShape&) {
  return {.title = translated("Slab"),
          .icon = QStringLiteral("slab"),
          .axes = {translated("Along x"), translated("Along y"), translated("Along z")}};
}

PartKind recordOf(const modeling::BezierPatchShape&) {
  return {.title = translated("Patch"),
          .icon = QStringLiteral("patch"),
          .axes = {translated("Along u"), translated("Along v"), translated("Through")},
          .editor = ShapeEditor::points,
          .points = &patchPoints()};
}

PartKind recordOf(const modeling::RevolutionShape&) {
  return {.title = translated("Solid of revolution"),
          .icon = QStringLiteral("revolution"),
          .axes = {translated("Around"), translated("Along"), translated("Through")},
          .editor = ShapeEditor::profile};
}

PartKind recordOf(const modeling::CurvedCylinderShape& shape) {
  const bool flat = shape.section == modeling::SweepSection::rectangle;
  return {.title = translated("Curved cylinder"),
          .icon = QStringLiteral("curved-cylinder"),
          .axes = {translated("Along"), flat ? translated("Across") : translated("Around"),
                   flat ? translated("Deep") : translated("Through")},
          .editor = ShapeEditor::points,
          .points = &sweepPoints()};
}

PartKind recordOf(const modeling::NetworkShape&) {
  return {.title = translated("Network"), .icon = QStringLiteral("network"), .axes = {}};
}

PartKind recordOf(const modeling::MeshShape&) {
  return {.title = translated("Solid of a mesh"), .icon = QStringLiteral("mesh"), .axes = {}};
}

modeling::SlabShape slab() {
  modeling::SlabShape shape;
  shape.size = Vec3(8.0, 8.0, 1.0);
  shape.resolution.cellSize = 0.5;
  return shape;
}

/// A solid disc: where the inside runs along the axis, nothing is hollow.
modeling::RevolutionShape turnedSolid() {
  using modeling::Vec2;
  modeling::RevolutionShape shape;
  shape.outside = {modeling::straightSegment(Vec2(0, 0), Vec2(2.5, 0)),
                   modeling::straightSegment(Vec2(2.5, 0), Vec2(2.5, 8)),
                   modeling::straightSegment(Vec2(2.5, 8), Vec2(0, 8))};
  shape.inside = {modeling::straightSegment(Vec2(0, 0), Vec2(0, 8))};
  shape.resolution.cellSize = 0.8;
  return shape;
}

/// A tile that is arched like a leaf, its edges on the ground.
modeling::BezierPatchShape patch() {
  modeling::BezierPatchShape shape;
  const double along[4] = {-4.0, -1.4, 1.4, 4.0};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const bool inner = j == 1 || j == 2;
      shape.net[i][j] = Vec3(along[i], along[j], inner ? 2.4 : 0.3);
    }
  }
  shape.thickness = 0.5;
  shape.resolution.cellSize = 0.5;
  return shape;
}

}  // namespace

PartKind kindOf(const modeling::PartShape& shape) {
  return std::visit([](const auto& kind) { return recordOf(kind); }, shape);
}

std::vector<NewThing> newParts() {
  std::vector<NewThing> things;
  for (const ProfilePreset preset : kProfilePresets) {
    things.push_back({.name = nameInScene(preset),
                      .title = nameOf(preset),
                      .help = translated("A dish turned from two profiles, which stay editable"),
                      .icon = QStringLiteral("revolution"),
                      .form = shapeOf(preset),
                      .preset = preset});
  }
  const auto add = [&](const char* name, const QString& title, const QString& icon, const QString& help,
                       modeling::PartShape shape, NewThing::AtWall atWall = nullptr) {
    things.push_back({name, title, help, icon, std::move(shape), std::nullopt, atWall});
  };
  add("handle", translated("Handle"), QStringLiteral("curved-cylinder"),
      translated("A curved bar; at the wall of the dish that is selected, and glued to it"), usualHandle(),
      handleAt);
  add("spout", translated("Spout"), QStringLiteral("spout"),
      translated("A curved tube; at the wall of the dish that is selected, and glued to it"), usualSpout(),
      spoutAt);
  add("slab", translated("Slab"), QStringLiteral("slab"), translated("A flat block: pane, tile, board"),
      slab());
  add("patch", translated("Patch"), QStringLiteral("patch"),
      translated("A wall along a curved surface with 16 control points"), patch());
  add("solid", translated("Solid of Revolution"), QStringLiteral("revolution"),
      translated("A full body turned from a profile"), turnedSolid());
  return things;
}

}  // namespace ui
