#pragma once

#include <string>

#include "modeling/import/lammps_box.h"
#include "modeling/import/lammps_data.h"

namespace modeling {

/// Bonds that go through a face of a periodic box, where their ends stand at opposite sides of it: nodes are
/// moved by whole boxes along such bonds, so that all bonds of what hangs together are as short as they can
/// be. A file does not say whether its box is periodic. So a bond counts as one that does where it spans more
/// than half the box, and its length through the face is nearer to what other bonds of its type have, which
/// span less; where there are none, where it is less than half as long through the face. Adds a note. A
/// Problem ("SOURCE:LINE:1") names a bond that closes a ring through the box: nothing that ends can be made
/// of that.
sim::Status unwrapBonds(const LammpsBox& box, const std::string& source, LammpsData& data);

}  // namespace modeling
