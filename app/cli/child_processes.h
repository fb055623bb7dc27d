#pragma once

#include <cstddef>
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
///
/// Where this program is asked to end meanwhile (SIGTERM, SIGINT, SIGHUP), the processes that run are ended,
/// no other is begun, and the signal is returned; 0 otherwise. They end with this program, too, where that is
/// killed.
int runChildProcesses(const std::vector<ChildProcess>& processes, std::size_t atATime,
                      const std::function<void(std::size_t index, int status)>& done);

/// Ends this program as the signal would have.
void endBySignal(int signal);

/// This program's own file.
std::string ownProgram();

}  // namespace app
