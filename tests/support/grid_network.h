#pragma once

#include <functional>

#include "sim/network/network.h"
#include "sim/state/snapshot.h"

/// Networks made by hand, for tests of what stands on networks but not of how they are modelled.
namespace tests {

/// A block of nx * ny * nz cells of edge 1, its corner at the origin, z innermost, edges as bonds. `place`
/// moves the corners; where it maps two corners to one point (a ring that closes), they are one node.
sim::Network gridNetwork(unsigned nx, unsigned ny, unsigned nz,
                         const std::function<sim::Vec3(const sim::Vec3&)>& place = nullptr,
                         bool ringInX = false);

/// Breaks all bonds that cross the plane of this x, cm, and the cells they are in. Fragments are not told
/// apart.
void breakBetween(const sim::Network& network, double x, sim::Snapshot& moment);

}  // namespace tests
