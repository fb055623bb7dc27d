#pragma once

#include <optional>
#include <string>

#include "modeling/shapes/lattice.h"

/// What must be true of every lattice, whatever its shape.
namespace tests {

/// The first of these that fails, in words: parameters in [0, 1] at every node; every node in a cell; no two
/// nodes in one place; every face in one cell or two; the faces in one cell form a closed surface (each of
/// its edges in exactly two, once each way); every corner of every cell right-handed.
std::optional<std::string> brokenLatticeRule(const modeling::Lattice& lattice);

/// Share of the cell edges that run between consecutive nodes.
double consecutiveShare(const modeling::Lattice& lattice);

}  // namespace tests
