#pragma once

#include <string>

#include "app/cli/command.h"
#include "sim/surface/cell_cuts.h"

namespace app {

/// --loose-nodes, of commands that show or write a surface. The name stays empty where the option is absent.
Option looseNodesOption(std::string& name);

/// What the name stands for: shards where it is empty.
sim::LooseNodes looseNodesNamed(const std::string& name);

}  // namespace app
