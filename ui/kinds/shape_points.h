#pragma once

#include <optional>
#include <set>
#include <vector>

#include "modeling/scene/part.h"

namespace ui {

enum class ShapePointKind {
  point,   ///< of a curve, or a control point of a patch
  handle,  ///< of the curve's point at ShapePoint::owner
  width,   ///< at the end of a section's half width
  depth,   ///< at the end of a section's half depth
};

/// Something of a shape that is dragged in the viewport.
struct ShapePoint {
  ShapePointKind kind = ShapePointKind::point;
  modeling::Vec3 at = modeling::Vec3::Zero();  ///< cm, part coordinates
  std::size_t owner = 0;                       ///< of a handle: the point it belongs to; else itself
};

struct ShapeLine {
  modeling::Vec3 from, to;  ///< cm, part coordinates
  bool isCurve = false;     ///< of the curve itself; else of a net or handle
};

/// The control points of a shape, and the lines that join them. Points keep their places in the list however
/// they are moved.
struct ShapePoints {
  std::vector<ShapePoint> points;
  std::vector<ShapeLine> lines;
};

/// A place on a curve of a shape.
struct CurvePoint {
  std::size_t curve = 0;  ///< of curvesOf()
  std::size_t segment = 0;
  double t = 0.0;  ///< 0 to 1 in the segment
};

/// Nothing for shapes whose points are not dragged in the viewport.
std::optional<ShapePoints> pointsOf(const modeling::PartShape& shape);
bool hasPoints(const modeling::PartShape& shape);

/// Moves some of the points, `by` in part coordinates (cm). A curve's point takes its handles along, the two
/// handles of a smooth point stay in line, and a section that is the same along the whole curve stays so,
/// unless `free`.
void movePoints(modeling::PartShape& shape, const std::set<std::size_t>& points, const modeling::Vec3& by,
                bool free = false);

/// The curves to which points can be added; some may be empty. They are those of `shape`, and live as long.
std::vector<const modeling::CurveChain*> curvesOf(const modeling::PartShape& shape);

/// Adds a point at a place of one of curvesOf(), and answers which of the points it is. The curve stays as it
/// is. Sizes that are given segment by segment get one there, too.
std::size_t insertPoint(modeling::PartShape& shape, const CurvePoint& place);

/// Takes points of curves away, with their handles, as far as a curve keeps two of them. Control points of a
/// patch, handles and sizes stay. False where nothing could be taken.
bool removePoints(modeling::PartShape& shape, const std::set<std::size_t>& points);

}  // namespace ui
