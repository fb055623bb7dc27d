#pragma once

#include <filesystem>

#include "app/cli/sweep_grid.h"

namespace app {

/// What a run leaves in the sweep's folder.
struct SweepFiles {
  std::filesystem::path take, report, log;

  SweepFiles(const std::filesystem::path& folder, std::size_t run);
};

/// Writes sweep.csv, sweep.json and sweep.png of what the runs left. The answer is how many have failed, or
/// left nothing: their row says so, and their place on the sheet is grey.
sim::Result<std::size_t> collectResults(const SweepGrid& grid, const std::filesystem::path& folder);

}  // namespace app
