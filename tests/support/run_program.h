#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tests {

/// What a program answered.
struct Answer {
  int status = -1;  ///< exit status; -1: it was ended by a signal
  std::string output;
  std::string errors;
};

/// Runs a shell command line to its end.
Answer runCommand(const std::string& command);

/// The most memory that the program had, bytes. `words` are its file and its arguments; what it says goes
/// nowhere.
std::size_t peakMemoryOf(const std::vector<std::string>& words);

/// smithereens-cli with these arguments. Where the build allows it, with at most 1 GB of memory.
Answer runCli(const std::string& arguments);

/// A folder of its own, empty, below the system's temporary folder.
std::string freshFolder(const std::string& name);

}  // namespace tests
