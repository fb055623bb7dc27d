#pragma once

#include <cstddef>

#include "sim/kernel/bond_kernel.h"

namespace sim {

/// Energy in intact bonds of lanes that are awake, erg; `step` describes the layout. Summed block by block in
/// order.
double elasticEnergy(const KernelStep& step, std::size_t blockCount);

}  // namespace sim
