#include "ui/kinds/wall_fit.h"

#include <algorithm>

#include "modeling/shapes/measured_chain.h"

namespace ui {
namespace {

using modeling::Vec3;

constexpr double kUsualCell = 0.5;  ///< cm

/// A point of a wall and the way out of it, in the plane of x and z.
struct Hold {
  Vec3 point = Vec3::Zero();
  Vec3 out = Vec3::UnitX();  ///< unit
};

/// From one hold out and back to a lower one.
modeling::CurvedCylinderShape handle(const Hold& upper, const Hold& lower, double cellSize) {
  modeling::CurvedCylinderShape shape;
  const double reach = 0.75 * (upper.point.z() - lower.point.z());
  shape.curve = {{upper.point, upper.point + reach * (upper.out + Vec3(0.0, 0.0, 0.15)),
                  lower.point + reach * (1.05 * lower.out - Vec3(0.0, 0.0, 0.1)), lower.point}};
  shape.section = modeling::SweepSection::rectangle;
  shape.firstAxis = Vec3::UnitZ();
  shape.halfWidth = modeling::constantValue(0.35);
  shape.halfDepth = modeling::constantValue(0.55);
  shape.resolution.cellSize = cellSize;
  return shape;
}

/// Out of the wall and up, narrower as it rises.
modeling::CurvedCylinderShape spout(const Hold& foot, double height, double cellSize) {
  modeling::CurvedCylinderShape shape;
  const double side = foot.out.x() < 0.0 ? -1.0 : 1.0;
  const Vec3 tip = foot.point + height * Vec3(0.62 * side, 0.0, 1.0);
  shape.curve = {{foot.point, foot.point + 0.5 * height * foot.out,
                  foot.point + height * Vec3(0.3 * side, 0.0, 0.75), tip}};
  shape.section = modeling::SweepSection::ring;
  shape.halfWidth = {{1.35, 1.1, 0.9, 0.8}};
  shape.halfDepth = {{1.35, 1.1, 0.9, 0.8}};
  shape.wallThickness = 0.4;
  shape.resolution.cellSize = cellSize;
  shape.resolution.counts[2] = 1;
  return shape;
}

/// At a share of a dish's height, on one side of its wall.
std::optional<Hold> holdOn(const modeling::RevolutionShape& dish, double share, double side) {
  const Eigen::AlignedBox3d box = dish.box();
  const double height = box.sizes().z();
  const double z = box.min().z() + share * height;
  const double near = 0.02 * height;
  const std::optional<double> below = outsideRadiusAt(dish, z - near);
  const std::optional<double> here = outsideRadiusAt(dish, z);
  const std::optional<double> above = outsideRadiusAt(dish, z + near);
  if (!below || !here || !above) return std::nullopt;
  const double slope = (*above - *below) / (2.0 * near);
  return Hold{Vec3(side * *here, 0.0, z), Vec3(side, 0.0, -slope).normalized()};
}

double cellAt(const modeling::RevolutionShape& dish) {
  return std::min(dish.resolution.cellSize, 0.6);
}

}  // namespace

modeling::CurvedCylinderShape usualHandle() {
  return handle({Vec3(0, 0, 6), Vec3::UnitX()}, {Vec3(0, 0, 2), Vec3::UnitX()}, kUsualCell);
}

modeling::CurvedCylinderShape usualSpout() {
  return spout({Vec3(0, 0, 1.5), Vec3::UnitX()}, 6.0, kUsualCell);
}

// A handle is on the left, a spout on the right, as of a teapot. A tube needs more height than a bar, or it
// would fold where it turns up.

std::optional<modeling::PartShape> handleAt(const modeling::RevolutionShape& dish) {
  constexpr double kLeastHeight = 2.5;
  if (dish.box().sizes().z() < kLeastHeight) return std::nullopt;
  const std::optional<Hold> upper = holdOn(dish, 0.8, -1.0);
  const std::optional<Hold> lower = holdOn(dish, 0.3, -1.0);
  if (!upper || !lower) return std::nullopt;
  return handle(*upper, *lower, cellAt(dish));
}

std::optional<modeling::PartShape> spoutAt(const modeling::RevolutionShape& dish) {
  constexpr double kLeastHeight = 7.0;
  const double height = dish.box().sizes().z();
  if (height < kLeastHeight) return std::nullopt;
  const std::optional<Hold> foot = holdOn(dish, 0.35, 1.0);
  if (!foot) return std::nullopt;
  return spout(*foot, 0.65 * height, cellAt(dish));
}

std::optional<double> outsideRadiusAt(const modeling::RevolutionShape& shape, double z) {
  constexpr int kSteps = 64;
  std::optional<double> radius;
  for (const auto& segment : shape.outside) {
    modeling::Vec2 before = segment[0];
    for (int i = 1; i <= kSteps; ++i) {
      const modeling::Vec2 after = modeling::evaluate(segment, static_cast<double>(i) / kSteps);
      const double low = std::min(before.y(), after.y());
      const double high = std::max(before.y(), after.y());
      if (z >= low && z <= high && high > low) {
        const double share = (z - before.y()) / (after.y() - before.y());
        const double here = before.x() + share * (after.x() - before.x());
        radius = std::max(radius.value_or(here), here);
      }
      before = after;
    }
  }
  return radius;
}

}  // namespace ui
