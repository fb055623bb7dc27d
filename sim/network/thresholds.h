#pragma once

#include <cstdint>

#include "sim/network/network.h"

namespace sim {

/// The breaking threshold t_ij of one bond (docs/numerics.md, Breaking 2): normally distributed about the
/// material's mean with its relative spread, cut at three standard deviations and kept above a twentieth of
/// the mean, so that no bond is born broken. Depends on seed and bond only.
float variedThreshold(const Material& material, std::uint64_t seed, BondIndex bond);

}  // namespace sim
