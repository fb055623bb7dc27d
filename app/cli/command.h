#pragma once

#include <vector>

#include "sim/base/result.h"

namespace CLI {
class App;
}

/// The headless program. Results go to standard output, progress and errors to standard error.
namespace app {

/// What the program answers to the shell.
enum class ExitStatus {
  done = 0,
  failed = 1,      ///< the run itself failed: a blow-up, a full disk
  wrongInput = 2,  ///< a file, a value or an option is wrong; one line says where and how to mend it
};

/// More threads than this are a slip of the finger.
inline constexpr int kMostThreads = 1024;

/// Prints the problem's line to standard error and returns the status, so that a command can `return` it.
ExitStatus complain(const sim::Problem& problem, ExitStatus status = ExitStatus::wrongInput);

/// Prints what a person should know of a file that was read all the same, a line a note, to standard error.
void tell(const std::vector<sim::Problem>& notes);

/// A command registers its name, options and callback with the program, and its callback leaves its answer in
/// `status`. One such function a command, each in its own file.
using AddCommand = void (*)(CLI::App& program, ExitStatus& status);

}  // namespace app
