#pragma once

#include "app/cli/command.h"

namespace app {

/// export TAKE --format xyz|obj --out PATH [--frames A:B]
void addExportCommand(CLI::App& program, ExitStatus& status);

}  // namespace app
