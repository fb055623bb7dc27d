#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/results/json.h"
#include "sim/base/result.h"

namespace app {

/// `bench throughput`: bond updates a second of the whole step (force, damping, break test, integration),
/// each bond counted once, on bodies from 3,700 to 500,000 nodes, beside a plain loop over bonds in the same
/// run. Prints a table; with a folder, writes throughput.json there.
sim::Status benchThroughput(const std::vector<int>& threads,
                            const std::optional<std::filesystem::path>& folder);

/// `bench scaling`: time a step against the number of nodes, for a solid slab and for loose cubes in contact.
/// It should grow as the number does (paper, "Collision detection"). Prints a table; with a folder, writes
/// scaling.json there.
sim::Status benchScaling(int threads, const std::optional<std::filesystem::path>& folder);

/// `bench skip`: scenes with and without each thing that may be left out (sim::SkipSettings), seconds and
/// difference of the result. Prints a table; with a folder, writes skip.json there. `quick` leaves out what
/// takes minutes.
sim::Status benchSkip(int threads, bool quick, const std::optional<std::filesystem::path>& folder);

/// Writes the rows into folder/name, making the folder. Without a folder nothing is written.
sim::Status writeRows(const std::optional<std::filesystem::path>& folder, const char* name,
                      const Json::Array& rows);

}  // namespace app
