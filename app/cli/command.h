#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim/base/result.h"

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

/// Where the value of an option goes. A bool is a flag, a vector takes the option several times, and an
/// optional keeps whether it was given.
using Target = std::variant<bool*, int*, double*, std::uint64_t*, std::string*, std::optional<double>*,
                            std::optional<std::uint64_t>*, std::vector<int>*, std::vector<std::string>*>;

/// The least and the largest number that an option takes.
struct Range {
  double least = 0.0;
  double most = 0.0;
};

/// One option of a command, as plain data: only command_line.cpp knows the library that reads it.
struct Option {
  std::string name;  ///< "--take"; without the dashes it is a word at its own place, which help calls so
  Target target;
  std::string help;
  bool required = false;
  bool oneAtATime = false;  ///< of a vector: each value stands behind an option of its own
  bool positive = false;    ///< of a number: it is above zero
  std::optional<Range> range = std::nullopt;
  std::vector<std::string> oneOf = {};  ///< the texts that are allowed; empty: any
  std::string excludes = "";            ///< name of an option before this one that it cannot stand beside
  std::string shownDefault = "";        ///< what help says an absent option means; "": nothing
};

/// --threads, of commands that run simulations. 0 stands for all there are.
Option threadsOption(int& threads);

/// --force, of commands that write files (modeling/files/output_guard.h).
Option forceOption(bool& force);

/// A command of the program. `run` is called when all options have been read.
struct Command {
  std::string name;
  std::string help;
  std::vector<Option> options = {};
  std::function<ExitStatus()> run = {};
  std::vector<Command> commands = {};  ///< where there are any, one of them has to be named
};

}  // namespace app
