#include <csignal>
#include <exception>
#include <iostream>
#include <new>

#include <CLI/CLI.hpp>

#include "app/cli/bench_command.h"
#include "app/cli/calibrate_command.h"
#include "app/cli/command.h"
#include "app/cli/export_command.h"
#include "app/cli/import_lammps_command.h"
#include "app/cli/info_command.h"
#include "app/cli/render_command.h"
#include "app/cli/resume_command.h"
#include "app/cli/simulate_command.h"
#include "app/cli/sweep_command.h"

namespace {

using app::AddCommand;
using app::ExitStatus;

/// Every command of the program, in the order in which help lists them.
constexpr std::initializer_list<AddCommand> kCommands = {
    app::addSimulateCommand, app::addResumeCommand,    app::addInfoCommand,
    app::addRenderCommand,   app::addExportCommand,    app::addImportLammpsCommand,
    app::addSweepCommand,    app::addCalibrateCommand, app::addBenchCommand};

ExitStatus runProgram(int argc, char** argv) {
  CLI::App program("Dishware that bends, hiccups, sneezes and breaks.", "smithereens-cli");
  program.require_subcommand(1);
  program.set_version_flag("--version", SMITHEREENS_VERSION);
  ExitStatus status = ExitStatus::done;
  for (const AddCommand add : kCommands) add(program, status);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& wish) {
    program.exit(wish);
    return ExitStatus::done;
  } catch (const CLI::ParseError& error) {
    return app::complain({"command line", error.what(), "see smithereens-cli --help"});
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
#ifdef SIGXFSZ
  // A file that may grow no further is a problem to be told of, as a full disk is, not the end of the
  // process.
  std::signal(SIGXFSZ, SIG_IGN);
#endif
  try {
    return static_cast<int>(runProgram(argc, argv));
  } catch (const std::bad_alloc&) {
    app::complain({"", "there is not enough memory for this", "use fewer cells"});
  } catch (const std::exception& error) {
    app::complain({"", std::string("an unexpected fault of the program: ") + error.what(),
                   "please report it with the command that led here"});
  }
  return static_cast<int>(ExitStatus::failed);
}
