#pragma once

#include <filesystem>
#include <functional>

#include "modeling/scene/scene.h"
#include "sim/take/take.h"

namespace modeling {

struct LammpsImport {
  /// Of nodes: id, vx vy vz, and positions as x y z, scaled (xs), unwrapped (xu) or both (xsu), wrapped ones
  /// with or without image flags (ix); other columns are passed over. `v_cm` is what a unit of length is in
  /// cm.
  std::filesystem::path dump;
  std::filesystem::path bonds;  ///< of the bonds there are: two ids a row; "": none broke
  /// Told after each frame how many there are; false stops.
  std::function<bool(std::size_t frames)> progress = {};
};

/// Makes a take of what LAMMPS dumped of a run that was exported from this scene (writeLammps()): positions
/// and velocities as dumped, bonds broken that are no longer in the dump, cells broken that have a broken
/// bond, fragments with parents and times of birth as ours. The ledger has the energies that follow from the
/// moment. `network` is the scene's. A dump of another scene is refused: by its number of nodes, its ids,
/// where the nodes are in step 0, or how far whole bonds are stretched. A Problem's place is in the dump;
/// what was read up to there is in the take, which is finished by the problem's words, unless it was in the
/// first moment.
sim::Result<std::size_t> importLammps(const LammpsImport& from, const Scene& scene,
                                      const sim::Network& network, const std::filesystem::path& take);

}  // namespace modeling
