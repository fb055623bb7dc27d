#pragma once

#include "app/cli/command.h"

namespace app {

/// simulate SCENE: builds the scene, runs it, records a take and a report.
void addSimulateCommand(CLI::App& program, ExitStatus& status);

}  // namespace app
