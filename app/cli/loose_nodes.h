#pragma once

#include <CLI/CLI.hpp>

#include "sim/surface/cell_cuts.h"

namespace app {

/// --loose-nodes, of commands that show or write a surface.
CLI::Option* addLooseNodes(CLI::App& command, sim::LooseNodes& looseNodes);

}  // namespace app
