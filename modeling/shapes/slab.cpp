#include "modeling/shapes/slab.h"

#include "modeling/shapes/cell_counts.h"
#include "modeling/shapes/grid.h"

namespace modeling {

sim::Result<Lattice> build(const SlabShape& shape) {
  if (!shape.size.allFinite() || !(shape.size.minCoeff() > 0.0))
    return sim::Problem{"size", "a slab needs three positive lengths",
                        "give width, depth and height in centimetres"};
  GridLayout layout;
  double nodes = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto count = cellsAlong(shape.resolution, axis, shape.size[static_cast<Eigen::Index>(axis)]);
    if (!count) return count.problem();
    layout.cells[axis] = *count;
    nodes *= *count + 1.0;
  }
  if (auto problem = checkNodeCount(nodes)) return *problem;
  return completed(gridLattice(layout,
                               [&](const Vec3& shares) -> Vec3 {
                                 return (shares - Vec3(0.5, 0.5, 0.0)).cwiseProduct(shape.size);
                               }),
                   "give the slab lengths that are not so unlike");
}

Eigen::AlignedBox3d SlabShape::box() const {
  return {Vec3(-0.5 * size.x(), -0.5 * size.y(), 0.0), Vec3(0.5 * size.x(), 0.5 * size.y(), size.z())};
}

}  // namespace modeling
