#pragma once

#include "app/cli/command.h"

namespace app {

/// render TAKE --out FILE.png [--time S | --frames A:B] [--size WxH] [--samples N]
void addRenderCommand(CLI::App& program, ExitStatus& status);

}  // namespace app
