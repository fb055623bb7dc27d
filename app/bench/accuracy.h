#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/base/result.h"

namespace app {

struct AccuracyOptions {
  bool quick = false;                           ///< small scenes, few steps: for tests
  std::vector<std::string> scenes;              ///< names; empty: all
  std::optional<std::filesystem::path> folder;  ///< for accuracy.json
  std::optional<std::filesystem::path> plots;   ///< for one plot a scene
};

/// `bench accuracy`: every method at its longest stable step and at fractions of it (implicit ones at
/// multiples), on scenes from one spring to a cup that lands: CPU time against errors of position, strain and
/// energy. Prints a table; with a folder, writes accuracy.json there.
sim::Status benchAccuracy(const AccuracyOptions& options);

}  // namespace app
