#pragma once

#include "app/cli/command.h"

namespace app {

/// export TAKE --format NAME --out PATH [--frames A:B]
void addExportCommand(CLI::App& program, ExitStatus& status);

}  // namespace app
