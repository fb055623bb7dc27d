#include "ui/kinds/point_handles.h"

namespace ui {
namespace {

using modeling::BezierPatchShape;
using modeling::ControlNet;
using modeling::PartShape;
using modeling::Vec3;

constexpr std::size_t kNetPoints = 16;

void addNet(const ControlNet& net, ShapePoints& shown) {
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      shown.points.push_back({ShapePointKind::point, net[i][j], shown.points.size()});
      if (i > 0) shown.lines.push_back({net[i - 1][j], net[i][j]});
      if (j > 0) shown.lines.push_back({net[i][j - 1], net[i][j]});
    }
}

ShapePoints shownOf(const BezierPatchShape& shape) {
  ShapePoints shown;
  addNet(shape.net, shown);
  if (shape.oppositeNet) addNet(*shape.oppositeNet, shown);
  return shown;
}

void moveIn(BezierPatchShape& shape, const std::set<std::size_t>& points, const Vec3& by) {
  for (const std::size_t point : points) {
    const std::size_t i = point % kNetPoints / 4;
    const std::size_t j = point % 4;
    if (point < kNetPoints) {
      shape.net[i][j] += by;
    } else if (shape.oppositeNet && point < 2 * kNetPoints) {
      (*shape.oppositeNet)[i][j] += by;
    }
  }
}

/// The points of the net come row by row, then those of the opposite net.
class PatchPoints : public PointHandles {
 public:
  ShapePoints shown(const PartShape& shape) const override {
    return shownOf(std::get<BezierPatchShape>(shape));
  }
  void move(PartShape& shape, const std::set<std::size_t>& points, const Vec3& by, bool) const override {
    moveIn(std::get<BezierPatchShape>(shape), points, by);
  }
};

}  // namespace

const PointHandles& patchPoints() {
  static const PatchPoints points;
  return points;
}

}  // namespace ui
