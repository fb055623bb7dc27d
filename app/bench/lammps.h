#pragma once

#include <optional>

#include "sim/network/network.h"

namespace app {

/// Bond updates a CPU second of LAMMPS (`lmp` on the path) on the same network: bond_style harmonic, fix nve,
/// one process, without damping, breaking and contact, all of which this program does besides. Nothing where
/// `lmp` is not installed or does not run.
std::optional<double> lammpsBondsPerSecond(const sim::Network& network, double step, int steps);

}  // namespace app
