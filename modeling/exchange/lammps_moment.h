#pragma once

#include <filesystem>
#include <vector>

#include "modeling/exchange/lammps_dump.h"
#include "sim/network/network.h"

/// The nodes of one moment of a dump, cm and cm/s, by the network's order.
namespace modeling {

struct LammpsMoment {
  double time = 0.0;  ///< s
  std::vector<sim::Vec3> positions, velocities;
};

/// All columns that anything is read from.
std::vector<std::string> lammpsNodeColumns();

/// The node of this id, counted from 1 in LAMMPS; nothing where there is none.
std::optional<sim::NodeIndex> lammpsNode(double id, std::size_t nodes);

/// Reads a moment. `before`: where nodes were, near which they are looked for where the box is periodic and
/// the dump does not say in which of its images they are. A Problem's place is FILE:LINE:1.
sim::Result<LammpsMoment> readLammpsMoment(const LammpsDumpFrame& frame, const std::filesystem::path& file,
                                           const std::vector<sim::Vec3>& before);

}  // namespace modeling
