#pragma once

#include <optional>
#include <string_view>

#include <Eigen/Geometry>

#include "modeling/shapes/lattice.h"
#include "modeling/shapes/resolution.h"
#include "sim/base/result.h"

namespace modeling {

/// A rectilinear slab (paper, "Geometric modeling"): centred on the origin in x and y, standing on z = 0.
/// u, v, w run along x, y, z.
struct SlabShape {
  static constexpr std::string_view kName = "slab";

  Vec3 size = Vec3(10.0, 10.0, 1.0);  ///< cm, each > 0
  Resolution resolution;

  /// Contains the solid, cm.
  Eigen::AlignedBox3d box() const;
  std::optional<double> cellEdge() const { return resolution.cellSize; }

  bool operator==(const SlabShape&) const = default;
};

sim::Result<Lattice> build(const SlabShape& shape);

}  // namespace modeling
