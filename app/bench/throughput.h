#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "app/results/json.h"
#include "sim/base/result.h"

namespace app {

/// `bench throughput`: how many bonds a second a whole step gets done (force, damping, break test,
/// integration), on bodies of 3,700 to 500,000 nodes. Each bond counts once. A plain loop over the same bonds
/// is measured in the same run, to compare. Prints a table and writes throughput.json into the folder, if
/// there is one.
sim::Status benchThroughput(const std::vector<int>& threads,
                            const std::optional<std::filesystem::path>& folder);

/// `bench scaling`: the time that a step takes against the number of nodes, for a solid slab and for loose
/// cubes in contact. It should grow as the number does (paper, "Collision detection"). Prints a table and
/// writes scaling.json into the folder, if there is one.
sim::Status benchScaling(int threads, const std::optional<std::filesystem::path>& folder);

/// `bench skip`: the seconds that scenes take with and without each thing that may be left out
/// (sim::SkipSettings), and how far the results differ. `quick` leaves out the scenes that take minutes.
/// Prints a table and writes skip.json into the folder, if there is one.
sim::Status benchSkip(int threads, bool quick, const std::optional<std::filesystem::path>& folder);

/// Writes the rows into folder/name, making the folder. Without a folder nothing is written.
sim::Status writeRows(const std::optional<std::filesystem::path>& folder, const char* name,
                      const Json::Array& rows);

}  // namespace app
