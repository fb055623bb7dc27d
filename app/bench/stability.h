#pragma once

#include <filesystem>
#include <optional>

#include "app/results/json.h"
#include "sim/base/result.h"

namespace app {

/// `bench stability`: what could make a run unstable, to its extremes, and what became of it. Prints a table;
/// with a folder, writes stability.json there.
sim::Status benchStability(bool quick, const std::optional<std::filesystem::path>& folder);

/// The rows of stability.json as a Markdown table, one line a group and method.
std::string stabilityTable(const Json::Array& rows);

}  // namespace app
