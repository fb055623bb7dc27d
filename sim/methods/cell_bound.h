#pragma once

#include <optional>

#include "sim/network/network.h"

namespace sim {

/// An upper bound of the eigenvalues of M^-1/2 K M^-1/2, 1/s^2: stiffness of bonds and mass of nodes are
/// split evenly among the cells that hold them, and the largest eigenvalue of any cell by itself bounds those
/// of the whole. Nothing where a bond is in no cell, so that cells say nothing of it.
std::optional<double> largestOfCells(const Network& network);

}  // namespace sim
