#pragma once

#include <functional>
#include <string>
#include <vector>

namespace app {

/// One program to be run: its file and its arguments, and where its output goes.
struct ChildProcess {
  std::vector<std::string> words;
  std::string log;  ///< file for standard output and errors
};

/// Runs the processes, so many at a time, in order. Calls done(index, exit status) as each ends, -1 where it
/// was ended by a signal or could not be started.
void runChildProcesses(const std::vector<ChildProcess>& processes, std::size_t atATime,
                       const std::function<void(std::size_t index, int status)>& done);

/// This program's own file.
std::string ownProgram();

}  // namespace app
