#pragma once

#include "app/cli/command.h"

namespace app {

/// sweep SCENE --vary PATH=A,B,C ... --out FOLDER [--jobs N] [--slurm]
void addSweepCommand(CLI::App& program, ExitStatus& status);

}  // namespace app
