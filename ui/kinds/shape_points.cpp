#include "ui/kinds/shape_points.h"

#include <cassert>

#include "ui/kinds/part_kinds.h"
#include "ui/kinds/point_handles.h"

namespace ui {

using modeling::PartShape;

std::optional<ShapePoints> pointsOf(const PartShape& shape) {
  const PointHandles* handles = kindOf(shape).points;
  return handles != nullptr ? std::optional(handles->shown(shape)) : std::nullopt;
}

bool hasPoints(const PartShape& shape) {
  return kindOf(shape).points != nullptr;
}

void movePoints(PartShape& shape, const std::set<std::size_t>& points, const modeling::Vec3& by, bool free) {
  if (const PointHandles* handles = kindOf(shape).points) handles->move(shape, points, by, free);
}

std::vector<const modeling::CurveChain*> curvesOf(const PartShape& shape) {
  const PointHandles* handles = kindOf(shape).points;
  return handles != nullptr ? handles->curves(shape) : std::vector<const modeling::CurveChain*>();
}

std::size_t insertPoint(PartShape& shape, const CurvePoint& place) {
  assert(place.curve < curvesOf(shape).size() && place.segment < curvesOf(shape)[place.curve]->size());
  return kindOf(shape).points->insert(shape, place);
}

bool removePoints(PartShape& shape, const std::set<std::size_t>& points) {
  const PointHandles* handles = kindOf(shape).points;
  return handles != nullptr && handles->remove(shape, points);
}

}  // namespace ui
