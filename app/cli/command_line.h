#pragma once

#include "app/cli/command.h"

namespace app {

/// Reads the command line and runs the command that it names. --help and --version are answered here; a line
/// that cannot be read is complained of as wrong input.
ExitStatus runCommandLine(const Command& program, const std::string& version, int argc, char** argv);

}  // namespace app
