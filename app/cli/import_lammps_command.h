#pragma once

#include "app/cli/command.h"

namespace app {

/// Brings a run of LAMMPS back as a take.
void addImportLammpsCommand(CLI::App& program, ExitStatus& status);

}  // namespace app
