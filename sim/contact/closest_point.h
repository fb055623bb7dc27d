#pragma once

#include "sim/base/types.h"

namespace sim {

/// The point of a triangle that is nearest to another, by its weights on the corners.
struct ClosestOnTriangle {
  Vec3 weights;
  unsigned corners =
      0;  ///< bit a corner: those with a weight. 7: within; 3, 5, 6: on an edge; 1, 2, 4: there
};
/// After Ericson, Real-Time Collision Detection (2005), 5.1.5.
ClosestOnTriangle closestOnTriangle(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c);

/// Where the lines through two edges are nearest to each other: a0 + s (a1 - a0) and b0 + t (b1 - b0).
struct ClosestOfEdges {
  double s = 0.0;
  double t = 0.0;
  bool parallel = true;  ///< then neither is known
};
ClosestOfEdges closestOfEdges(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1);

}  // namespace sim
