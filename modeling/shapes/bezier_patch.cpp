#include "modeling/shapes/bezier_patch.h"

#include <cmath>

#include <Eigen/Geometry>

#include "modeling/shapes/cell_counts.h"
#include "modeling/shapes/grid.h"
#include "modeling/shapes/measured_chain.h"

namespace modeling {
namespace {

constexpr const char* kRemedy = "make it thinner or flatter, keep the nets apart, and draw out their corners";

/// The curve of a net at one v (along u), or at one u (along v), as a Bezier segment.
CubicSegment<Vec3> curveAlongU(const ControlNet& net, double v) {
  CubicSegment<Vec3> curve;
  for (std::size_t i = 0; i < 4; ++i) curve[i] = evaluate(net[i], v);
  return curve;
}
CubicSegment<Vec3> curveAlongV(const ControlNet& net, double u) {
  CubicSegment<Vec3> curve;
  for (std::size_t j = 0; j < 4; ++j)
    curve[j] = evaluate(CubicSegment<Vec3>{net[0][j], net[1][j], net[2][j], net[3][j]}, u);
  return curve;
}

Vec3 pointOn(const ControlNet& net, double u, double v) {
  return evaluate(curveAlongU(net, v), u);
}

Vec3 normalOf(const ControlNet& net, double u, double v) {
  return derivative(curveAlongU(net, v), u).cross(derivative(curveAlongV(net, u), v)).normalized();
}

ControlNet middleNet(const BezierPatchShape& shape) {
  if (!shape.oppositeNet) return shape.net;
  ControlNet middle;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) middle[i][j] = 0.5 * (shape.net[i][j] + (*shape.oppositeNet)[i][j]);
  return middle;
}

std::optional<sim::Problem> check(const BezierPatchShape& shape) {
  for (const ControlNet* net : {&shape.net, shape.oppositeNet ? &*shape.oppositeNet : &shape.net})
    for (const auto& row : *net)
      for (const Vec3& point : row)
        if (!point.allFinite())
          return sim::Problem{net == &shape.net ? "net" : "oppositeNet", "a control point is not finite",
                              "give finite numbers"};
  if (!shape.oppositeNet && !(shape.thickness > 0.0 && std::isfinite(shape.thickness)))
    return sim::Problem{"thickness", "the thickness must be a positive number of centimetres",
                        "use for example 0.4"};
  const ControlNet middle = middleNet(shape);
  for (const auto& curve : {curveAlongU(middle, 0.5), curveAlongV(middle, 0.5)})
    if (auto problem = checkChain(CurveChain{curve}, "net")) return problem;
  return std::nullopt;
}

double meanThickness(const BezierPatchShape& shape) {
  if (!shape.oppositeNet) return shape.thickness;
  constexpr int kSamples = 8;
  double sum = 0.0;
  for (int i = 0; i <= kSamples; ++i)
    for (int j = 0; j <= kSamples; ++j) {
      const double u = static_cast<double>(i) / kSamples, v = static_cast<double>(j) / kSamples;
      sum += (pointOn(*shape.oppositeNet, u, v) - pointOn(shape.net, u, v)).norm();
    }
  return sum / ((kSamples + 1) * (kSamples + 1));
}

}  // namespace

sim::Result<Lattice> build(const BezierPatchShape& shape) {
  if (auto problem = check(shape)) return *problem;
  const ControlNet middle = middleNet(shape);
  const MeasuredChain<Vec3> alongU({curveAlongU(middle, 0.5)}), alongV({curveAlongV(middle, 0.5)});
  const std::array<double, 3> lengths{alongU.length(), alongV.length(), meanThickness(shape)};
  GridLayout layout;
  double nodes = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto count = cellsAlong(shape.resolution, axis, lengths[axis]);
    if (!count) return count.problem();
    layout.cells[axis] = *count;
    nodes *= *count + 1.0;
  }
  if (auto problem = checkNodeCount(nodes)) return *problem;

  const double back = shape.side == PatchSide::outside ? 0.0 : shape.side == PatchSide::inside ? -1.0 : -0.5;
  const auto place = [&](const Vec3& shares) -> Vec3 {
    const double u = alongU.atShare(shares.x()).t, v = alongV.atShare(shares.y()).t, w = shares.z();
    if (shape.oppositeNet)
      return (1.0 - w) * pointOn(shape.net, u, v) + w * pointOn(*shape.oppositeNet, u, v);
    return pointOn(shape.net, u, v) + (back + w) * shape.thickness * normalOf(shape.net, u, v);
  };
  return completed(gridLattice(layout, place), kRemedy);
}

Eigen::AlignedBox3d BezierPatchShape::box() const {
  // Surfaces stay within the hull of their control points.
  Eigen::AlignedBox3d box;
  for (const auto& row : net)
    for (const Vec3& point : row) box.extend(point);
  if (!oppositeNet) {
    box.min().array() -= thickness;
    box.max().array() += thickness;
    return box;
  }
  for (const auto& row : *oppositeNet)
    for (const Vec3& point : row) box.extend(point);
  return box;
}

}  // namespace modeling
