#pragma once

#include "app/cli/command.h"

namespace app {

/// resume TAKE: goes on from the last checkpoint of a run that was killed, or past the end of one that was
/// not, bit for bit as the unbroken run would have.
void addResumeCommand(CLI::App& program, ExitStatus& status);

}  // namespace app
