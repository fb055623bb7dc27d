#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/base/types.h"

namespace modeling {

/// Appends triangles that together are the polygon, with its winding, by cutting off ears: the polygon may be
/// bent inwards, but should lie about in a plane. Corners that follow each other in one place are one. Fewer
/// than three make nothing. Every index must be a point's.
void addTrianglesOf(std::vector<std::uint32_t> ring, const std::vector<sim::Vec3>& points,
                    std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace modeling
