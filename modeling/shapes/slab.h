#pragma once

#include "modeling/shapes/lattice.h"
#include "modeling/shapes/resolution.h"
#include "sim/base/result.h"

namespace modeling {

/// A rectilinear slab (paper, "Geometric modeling"): centred on the origin in x and y, standing on z = 0.
/// u, v, w run along x, y, z.
struct SlabShape {
  Vec3 size = Vec3(10.0, 10.0, 1.0);  ///< cm, each > 0
  Resolution resolution;

  bool operator==(const SlabShape&) const = default;
};

sim::Result<Lattice> build(const SlabShape& shape);

}  // namespace modeling
