#pragma once

#include <vector>

#include "sim/base/result.h"
#include "sim/collider/triangle_mesh.h"

namespace sim {

/// No corner of a surface may be further from its origin along an axis, cm: ten kilometres. Squares and
/// volumes of such lengths are exact enough to tell millimetres, and far from what a double can't hold.
inline constexpr double kFarthestCorner = 1e6;
/// A corner is taken for a stray where it is so many times as far out as all others.
inline constexpr double kStrayRatio = 1000.0;

/// Whether a surface can be collided with or filled. A Problem without a place where it can't: there is no
/// triangle, or none has an area; a corner is no number, further than kFarthestCorner, or a stray. Corners
/// that no triangle names do not count. Every index must be a point's. cm.
Status checkSurface(const std::vector<Vec3>& points, const std::vector<TriangleMesh::Triangle>& triangles);

}  // namespace sim
