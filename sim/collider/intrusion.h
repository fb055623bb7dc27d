#pragma once

#include <cstdint>

#include "sim/base/types.h"

namespace sim {

/// How deep a point is inside a collider, and the way out. A depth of at most 0 means outside, by at least
/// -depth; each kind says where that is exact.
struct Intrusion {
  double depth = 0.0;             ///< cm
  Vec3 normal = Vec3::UnitZ();    ///< unit, out of the collider
  std::uint32_t nearest = kNone;  ///< the nearest triangle, where there are triangles
};

}  // namespace sim
