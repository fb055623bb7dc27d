#pragma once

#include <string>

#include "tests/fuzz/chance.h"

namespace tests {

/// Changes something in a take and seals it again, so that it is not the checksum that tells: a field of a
/// chunk's header becomes huge, or something inside a chunk changes. Bytes that are no take stay as they are.
void damageTake(std::string& bytes, Chance& chance);

}  // namespace tests
