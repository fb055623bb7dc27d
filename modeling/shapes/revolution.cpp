#include "modeling/shapes/revolution.h"

#include <cmath>

#include "modeling/shapes/cell_counts.h"
#include "modeling/shapes/grid.h"
#include "modeling/shapes/turned_body.h"
#include "modeling/shapes/turned_plan.h"

namespace modeling {
namespace {

constexpr const char* kRemedy =
    "keep the profiles apart and smooth, let corners face each other, or use smaller cells";

bool isFullTurn(double angle) {
  return angle > 2.0 * std::numbers::pi - 1e-9;
}

std::optional<sim::Problem> checkAngles(const RevolutionShape& shape) {
  if (!std::isfinite(shape.startAngle))
    return sim::Problem{"startAngle", "the start angle is not finite", "give a finite angle"};
  if (shape.turnAngle > 0.0 && shape.turnAngle <= 2.0 * std::numbers::pi + 1e-9) return std::nullopt;
  return sim::Problem{"turnAngle", "a turn must be more than 0 and at most 360 degrees",
                      "use 360 for a full turn"};
}

Vec3 wallPoint(const WallProfile& profile, const RevolutionShape& shape, const Vec3& shares) {
  const WallProfile::Pair pair = profile.pairAt(shares.y() * profile.length());
  const Vec2 point = (1.0 - shares.z()) * pair.inside + shares.z() * pair.outside;
  const double angle = shape.startAngle + shares.x() * shape.turnAngle;
  return {point.x() * std::cos(angle), point.x() * std::sin(angle), point.y()};
}

sim::Result<Lattice> buildOpenWall(const WallProfile& profile, const RevolutionShape& shape, int around,
                                   int through) {
  const auto along = cellsAlong(shape.resolution, 1, profile.length());
  if (!along) return along.problem();
  if (auto problem = checkNodeCount((around + 1.0) * (*along + 1.0) * (through + 1.0))) return *problem;
  const GridLayout layout{{around, *along, through}, {isFullTurn(shape.turnAngle), false, false}};
  return gridLattice(layout, [&](const Vec3& shares) { return wallPoint(profile, shape, shares); });
}

sim::Result<Lattice> buildClosedWall(const WallProfile& profile, const RevolutionShape& shape, int around,
                                     int through) {
  const auto layout = planTurned(profile, shape, around);
  if (!layout) return layout.problem();
  const double sheetNodes = (layout->startClosed ? discNodeCount(layout->startDisc) : 0.0) +
                            (layout->endClosed ? discNodeCount(layout->endDisc) : 0.0) +
                            (around + 1.0) * layout->rowsBetween;
  if (auto problem = checkNodeCount(sheetNodes * (through + 1.0))) return *problem;
  const TurnedSheet turned = turnedSheet(*layout);
  return stack(turned.sheet, through, LayerOrder::betweenRows, [&](const Vec2& point, int layer) {
    const Vec3 shares(point[0], point[1] / profile.length(), static_cast<double>(layer) / through);
    return PlacedNode{wallPoint(profile, shape, shares), shares};
  });
}

}  // namespace

sim::Result<Lattice> build(const RevolutionShape& shape) {
  if (auto problem = checkAngles(shape)) return *problem;
  const auto profile = WallProfile::make(shape);
  if (!profile) return profile.problem();

  const bool discs = profile->solid() || profile->startClosed() || profile->endClosed();
  const int least = isFullTurn(shape.turnAngle) ? 3 : 1;
  const int pair = 2 * discSectors(shape.turnAngle);
  const auto around = cellsAlong(shape.resolution, 0, shape.turnAngle * profile->largestRadius(),
                                 discs ? pair : 1, discs ? pair : least);
  if (!around) return around.problem();
  const double sectors = discSectors(shape.turnAngle);
  if (discs)  // before anything of that size is laid out
    if (auto problem = checkNodeCount(0.25 * *around * *around / sectors)) return *problem;

  if (profile->solid()) {
    auto body = buildTurnedBody(*profile, shape, *around);
    return body ? completed(std::move(body).value(), kRemedy) : body;
  }
  const auto through = cellsAlong(shape.resolution, 2, profile->meanThickness());
  if (!through) return through.problem();
  auto wall = profile->startClosed() || profile->endClosed()
                  ? buildClosedWall(*profile, shape, *around, *through)
                  : buildOpenWall(*profile, shape, *around, *through);
  return wall ? completed(std::move(wall).value(), kRemedy) : wall;
}

Eigen::AlignedBox3d RevolutionShape::box() const {
  // Curves stay within the hull of their control points.
  Eigen::AlignedBox3d box;
  for (const ProfileChain* profile : {&outside, &inside}) {
    for (const auto& segment : *profile)
      for (const Vec2& point : segment) {
        box.extend(Vec3(point.x(), point.x(), point.y()));
        box.extend(Vec3(-point.x(), -point.x(), point.y()));
      }
  }
  return box;
}

}  // namespace modeling
