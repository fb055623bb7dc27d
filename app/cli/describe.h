#pragma once

#include <filesystem>

#include "app/results/json.h"
#include "sim/base/result.h"

/// What is in a file, as JSON with the units in the names of its keys (docs/formats.md, "Info").
namespace app {

/// Built, not run: counts, sizes, quality of cells, glue, and the pre-flight: the stable step, the bonds that
/// would break before anything moves, the time a run would take here (a few steps are made and measured), and
/// how large its take would be.
sim::Result<Json> describeScene(const std::filesystem::path& file);
sim::Result<Json> describeTake(const std::filesystem::path& file);
/// A LAMMPS data file.
sim::Result<Json> describeNetwork(const std::filesystem::path& file);

/// By the file's extension (.json, .take, .data), else by how it begins.
sim::Result<Json> describe(const std::filesystem::path& file);

}  // namespace app
