#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/base/result.h"
#include "sim/base/types.h"

/// The LAMMPS data file (`read_data`): raw nodes and bonds, of atom_style bond unless the section `Atoms`
/// says otherwise. Units are the file's; we take them as cgs.
///
/// Read: the counts and the box of the header, tilted or not; `Masses`; `Atoms`, with image flags, by which
/// positions are unwrapped; `Velocities`; `Bonds`; type labels. Bonds that go through a face of the box are
/// made short (lammps_unwrap.h). `... Coeffs` sections are passed over: constants come from the scene. Any
/// other section that holds something is a Problem, since dropping it would change what moves.
namespace modeling {

struct LammpsBond {
  int type = 0;         ///< >= 1
  std::uint32_t a = 0;  ///< index of a node, not its id
  std::uint32_t b = 0;
  std::uint32_t line = 0;  ///< of the file, from 1
  std::int64_t id = 0;     ///< as the file numbers it
};

/// Nodes in the order of the file's `Atoms` lines, bonds in that of its `Bonds` lines. No pair is bonded
/// twice, no node to itself nor to one in the same place; every number is finite, every mass positive.
struct LammpsData {
  std::vector<sim::Vec3> positions;
  std::vector<sim::Vec3> velocities;  ///< empty, or one a node
  std::vector<double> masses;         ///< one a node
  std::vector<LammpsBond> bonds;
  std::uint32_t atomsLine = 0;     ///< where the `Atoms` section begins
  std::vector<std::string> notes;  ///< what a person should know of how it was taken
};

/// Larger files are refused before they are read: beyond this, memory rather than a limit of ours would end
/// the run.
inline constexpr std::uintmax_t kLargestLammpsFile = 128U << 20U;  ///< bytes

/// A Problem has "SOURCE:LINE:COLUMN". Memory grows with what the text holds, never with what its header
/// claims.
sim::Result<LammpsData> parseLammpsData(std::string_view text, const std::string& source);
/// The file may be packed by gzip.
sim::Result<LammpsData> loadLammpsData(const std::filesystem::path& file);

}  // namespace modeling
