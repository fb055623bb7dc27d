#pragma once

#include <functional>

#include "sim/network/network.h"

/// Networks made by hand, for tests of what stands on networks but not of how they are modelled.
namespace tests {

/// A block of nx * ny * nz cells of edge 1, its corner at the origin, z innermost, edges as bonds. `place`
/// moves the corners; where it maps two corners to one point (a ring that closes), they are one node.
sim::Network gridNetwork(unsigned nx, unsigned ny, unsigned nz,
                         const std::function<sim::Vec3(const sim::Vec3&)>& place = nullptr,
                         bool ringInX = false);

}  // namespace tests
