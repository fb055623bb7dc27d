#pragma once

#include <numbers>

#include "modeling/shapes/curved_cylinder.h"
#include "modeling/shapes/revolution.h"

/// Parts of Martin Newell's teapot (public domain control points), at 4.5 cm a unit, as test shapes.
namespace tests {

inline constexpr double kTeapotUnit = 4.5;  ///< cm

inline modeling::CubicSegment<modeling::Vec3> inPlane(std::array<std::array<double, 2>, 4> xz) {
  modeling::CubicSegment<modeling::Vec3> segment;
  for (std::size_t i = 0; i < 4; ++i) segment[i] = kTeapotUnit * modeling::Vec3(xz[i][0], 0.0, xz[i][1]);
  return segment;
}

inline modeling::CubicSegment<modeling::Vec2> inProfile(std::array<std::array<double, 2>, 4> rz) {
  modeling::CubicSegment<modeling::Vec2> segment;
  for (std::size_t i = 0; i < 4; ++i) segment[i] = kTeapotUnit * modeling::Vec2(rz[i][0], rz[i][1]);
  return segment;
}

/// The body, with a wall about 0.4 cm thick.
inline modeling::RevolutionShape teapotBody(double cellSize) {
  modeling::RevolutionShape shape;
  shape.outside = {inProfile({{{1.5, 2.4}, {1.75, 1.875}, {2, 1.35}, {2, 0.9}}}),
                   inProfile({{{2, 0.9}, {2, 0.45}, {1.5, 0.225}, {1.5, 0.15}}}),
                   inProfile({{{1.5, 0.15}, {1.5, 0.075}, {1.425, 0}, {0, 0}}})};
  shape.inside = {inProfile({{{1.41, 2.4}, {1.66, 1.875}, {1.91, 1.35}, {1.91, 0.9}}}),
                  inProfile({{{1.91, 0.9}, {1.91, 0.5}, {1.43, 0.29}, {1.41, 0.2}}}),
                  inProfile({{{1.41, 0.2}, {1.41, 0.14}, {1.33, 0.09}, {0, 0.09}}})};
  shape.resolution.cellSize = cellSize;
  return shape;
}

inline modeling::CurvedCylinderShape teapotHandleHalf(bool upper, double cellSize) {
  modeling::CurvedCylinderShape shape;
  shape.section = modeling::SweepSection::disc;
  if (upper) {
    shape.curve = {inPlane({{{-1.6, 2.025}, {-2.3, 2.025}, {-2.7, 2.025}, {-2.7, 1.8}}})};
    shape.secondRail = {inPlane({{{-1.5, 2.25}, {-2.5, 2.25}, {-3, 2.25}, {-3, 1.8}}})};
  } else {
    shape.curve = {inPlane({{{-2.7, 1.8}, {-2.7, 1.575}, {-2.5, 1.125}, {-2, 0.9}}})};
    shape.secondRail = {inPlane({{{-3, 1.8}, {-3, 1.35}, {-2.65, 0.9375}, {-1.9, 0.6}}})};
  }
  shape.halfDepth = modeling::constantValue(0.3 * kTeapotUnit);
  shape.resolution.cellSize = cellSize;
  return shape;
}

inline modeling::CurvedCylinderShape teapotSpoutHalf(bool left, double cellSize) {
  modeling::CurvedCylinderShape shape;
  shape.section = modeling::SweepSection::arc;
  shape.curve = {inPlane({{{1.7, 0.6}, {3.1, 0.825}, {2.4, 2.025}, {3.3, 2.4}}})};
  shape.secondRail = {inPlane({{{1.7, 1.425}, {2.6, 1.425}, {2.3, 2.1}, {2.7, 2.4}}})};
  const double unit = kTeapotUnit;
  shape.halfDepth = {{0.66 * unit, 0.66 * unit, 0.25 * unit, 0.25 * unit}};
  shape.wallThickness = 0.4;
  shape.startAngle = left ? 0.0 : std::numbers::pi;
  shape.endAngle = shape.startAngle + std::numbers::pi;
  shape.resolution.cellSize = cellSize;
  return shape;
}

}  // namespace tests
