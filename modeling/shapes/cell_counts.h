#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "modeling/shapes/resolution.h"
#include "sim/base/result.h"

namespace modeling {

/// Cells along one axis (0: u, 1: v, 2: w) of the given length, cm: the count of the resolution where it has
/// one, otherwise the number nearest to length / cellSize. `multiple`: what the count must be divisible by;
/// `least`: the smallest count that makes sense (itself such a multiple).
sim::Result<int> cellsAlong(const Resolution& resolution, std::size_t axis, double length, int multiple = 1,
                            int least = 1);

/// "12000", "3.5 million".
std::string roughCount(double count);

/// A Problem where a lattice would have more than kMaxLatticeNodes.
std::optional<sim::Problem> checkNodeCount(double nodes);

}  // namespace modeling
