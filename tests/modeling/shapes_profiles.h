#pragma once

#include <cmath>

#include "modeling/shapes/revolution.h"

/// Profiles the shape tests share.
namespace tests {

/// A circle's arc about the origin of the half-plane, in cubic segments; angles from the r axis. Off the true
/// circle by 3e-4 of the radius at most for quarter turns.
inline modeling::ProfileChain arcProfile(double radius, double from, double to, int segments = 2) {
  using modeling::Vec2;
  modeling::ProfileChain chain;
  for (int i = 0; i < segments; ++i) {
    const double a = from + (to - from) * i / segments, b = from + (to - from) * (i + 1) / segments;
    const double handle = 4.0 / 3.0 * std::tan((b - a) / 4.0);
    const Vec2 start(radius * std::cos(a), radius * std::sin(a)),
        end(radius * std::cos(b), radius * std::sin(b));
    chain.push_back({start, Vec2(start + handle * Vec2(-start.y(), start.x())),
                     Vec2(end - handle * Vec2(-end.y(), end.x())), end});
  }
  if (std::abs(chain.front()[0].x()) < 1e-12) chain.front()[0].x() = 0.0;
  if (std::abs(chain.back()[3].x()) < 1e-12) chain.back()[3].x() = 0.0;
  return chain;
}

inline modeling::ProfileChain lineProfile(double r0, double z0, double r1, double z1) {
  return {modeling::straightSegment(modeling::Vec2(r0, z0), modeling::Vec2(r1, z1))};
}

/// A cup 9 cm high with a rounded foot: base closed on the axis, wall 0.5 cm.
inline modeling::RevolutionShape cup(double cellSize) {
  using modeling::Vec2;
  modeling::RevolutionShape shape;
  shape.outside = {modeling::straightSegment(Vec2(0, 0), Vec2(3, 0)),
                   {Vec2(3, 0), Vec2(3.6, 0), Vec2(4, 0.4), Vec2(4, 1)},
                   modeling::straightSegment(Vec2(4, 1), Vec2(4, 9))};
  shape.inside = {modeling::straightSegment(Vec2(0, 0.5), Vec2(2.8, 0.5)),
                  {Vec2(2.8, 0.5), Vec2(3.2, 0.5), Vec2(3.5, 0.8), Vec2(3.5, 1.2)},
                  modeling::straightSegment(Vec2(3.5, 1.2), Vec2(3.5, 9))};
  shape.resolution.cellSize = cellSize;
  return shape;
}

}  // namespace tests
