#pragma once

#include "app/cli/command.h"

namespace app {

void addBenchCommand(CLI::App& program, ExitStatus& status);

}  // namespace app
