#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "modeling/import/lammps_box.h"
#include "modeling/text/line_tokens.h"
#include "sim/base/result.h"

namespace modeling {

/// What stands above the sections of a LAMMPS data file.
struct LammpsHeader {
  struct Count {
    std::int64_t value = 0;
    std::uint32_t line = 0;  ///< 0: not stated
  };
  Count atoms, bonds, bondTypes;

  /// The box, where it is stated whole.
  std::optional<LammpsBox> box() const;

  // How the box is stated: by bounds, or by edges.
  sim::Vec3 low = sim::Vec3::Zero();
  sim::Vec3 high = sim::Vec3::Zero();
  sim::Vec3 tilt = sim::Vec3::Zero();
  LammpsBox general;
  unsigned stated = 0;  ///< bits 0 to 2: the bounds of x, y and z; 3 to 5: avec, bvec and cvec
};

/// Takes a line. False where it is none of the header's. A Problem, whose place is the line's column alone,
/// for what nodes and bonds cannot stand for.
sim::Result<bool> readLammpsHeaderLine(const std::vector<Token>& words, std::uint32_t line,
                                       LammpsHeader& header);

}  // namespace modeling
