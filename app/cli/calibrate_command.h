#pragma once

#include "app/cli/command.h"

namespace app {

void addCalibrateCommand(CLI::App& program, ExitStatus& status);

}  // namespace app
