#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

#include "sim/base/types.h"

namespace modeling {

using sim::Vec3;
using Vec2 = Eigen::Vector2d;

/// One cubic Bezier segment by its four control points; it starts at the first and ends at the last.
template <class Point>
using CubicSegment = std::array<Point, 4>;

/// Segments end to end: each starts where the one before ends (to 1e-6 of the chain's size).
template <class Point>
using CubicChain = std::vector<CubicSegment<Point>>;

using ProfileChain = CubicChain<Vec2>;  ///< (r, z), cm
using CurveChain = CubicChain<Vec3>;    ///< cm
using ValueChain = CubicChain<double>;  ///< a number that varies along a curve

/// A straight segment as a cubic with evenly spaced control points.
template <class Point>
CubicSegment<Point> straightSegment(const Point& start, const Point& end) {
  return {start, Point((2.0 * start + end) / 3.0), Point((start + 2.0 * end) / 3.0), end};
}

/// A number that stays the same along a whole curve.
inline ValueChain constantValue(double value) {
  return {{value, value, value, value}};
}

}  // namespace modeling
