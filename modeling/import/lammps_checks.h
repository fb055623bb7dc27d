#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "modeling/import/lammps_data.h"

namespace modeling {

/// Two nodes that are in one place, the lower one first; nothing where there are none.
std::optional<std::pair<std::uint32_t, std::uint32_t>> twoInOnePlace(const std::vector<sim::Vec3>& positions);

/// The later of two bonds between the same nodes.
std::optional<LammpsBond> secondOfPair(const std::vector<LammpsBond>& bonds);

}  // namespace modeling
