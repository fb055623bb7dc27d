#pragma once

#include <filesystem>
#include <optional>

#include "sim/base/result.h"

namespace app {

/// `bench contact`: how bodies touch (gap, sliding, friction at rest, penetration, rest, rebound, what begins
/// inside, quasi-static bending, cost), each scene by surfaces and by nodes (sim::ContactKind), one thread.
/// `quick` leaves out what takes more than some 5 s of the processor. Prints a table; with a folder, writes
/// contact.json there. A Problem where a scene cannot be built or blows up, or the file cannot be written.
sim::Status benchContact(bool quick, const std::optional<std::filesystem::path>& folder);

}  // namespace app
