#pragma once

#include "app/cli/command.h"

namespace app {

/// info FILE [--json]: what is in a scene, a take or a network file.
void addInfoCommand(CLI::App& program, ExitStatus& status);

}  // namespace app
