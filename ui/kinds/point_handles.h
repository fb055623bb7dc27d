#pragma once

#include <set>
#include <vector>

#include "ui/kinds/shape_points.h"

namespace ui {

/// How the points of one kind of part are shown and changed (shape_points.h). Every shape that is given is of
/// the kind.
class PointHandles {
 public:
  virtual ~PointHandles() = default;

  virtual ShapePoints shown(const modeling::PartShape& shape) const = 0;
  virtual void move(modeling::PartShape& shape, const std::set<std::size_t>& points, const modeling::Vec3& by,
                    bool free) const = 0;
  /// Of a kind without curves: none, and insert() is never called.
  virtual std::vector<const modeling::CurveChain*> curves(const modeling::PartShape&) const { return {}; }
  virtual std::size_t insert(modeling::PartShape&, const CurvePoint&) const { return 0; }
  virtual bool remove(modeling::PartShape&, const std::set<std::size_t>&) const { return false; }
};

/// Of a Bezier patch.
const PointHandles& patchPoints();
/// Of a curved cylinder.
const PointHandles& sweepPoints();

}  // namespace ui
