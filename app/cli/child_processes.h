#pragma once

#include <functional>
#include <string>
#include <vector>

namespace app {

/// One command to be run: the program and its arguments, and where its output goes.
struct Command {
  std::vector<std::string> words;
  std::string log;  ///< file for standard output and errors
};

/// Runs the commands, so many at a time, in order. Calls done(index, exit status) as each ends, -1 where it
/// was ended by a signal or could not be started.
void runCommands(const std::vector<Command>& commands, std::size_t atATime,
                 const std::function<void(std::size_t index, int status)>& done);

/// This program's own file.
std::string ownProgram();

}  // namespace app
