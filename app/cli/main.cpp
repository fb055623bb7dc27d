#include <csignal>
#include <exception>
#include <new>

#include "app/cli/command_line.h"
#include "app/cli/commands.h"

namespace {

using app::ExitStatus;

/// Commands stand in the order in which help lists them.
app::Command program() {
  return {.name = "smithereens-cli",
          .help = "Dishware that bends, hiccups, sneezes and breaks.",
          .commands = {app::simulateCommand(), app::resumeCommand(), app::infoCommand(), app::renderCommand(),
                       app::exportCommand(), app::importLammpsCommand(), app::sweepCommand(),
                       app::calibrateCommand(), app::benchCommand()}};
}

}  // namespace

int main(int argc, char** argv) {
#ifdef SIGXFSZ
  // A file that may grow no further is a problem to be told of, as a full disk is, not the end of the
  // process.
  std::signal(SIGXFSZ, SIG_IGN);
#endif
  try {
    return static_cast<int>(app::runCommandLine(program(), SMITHEREENS_VERSION, argc, argv));
  } catch (const std::bad_alloc&) {
    app::complain({"", "there is not enough memory for this", "use fewer cells"});
  } catch (const std::exception& error) {
    app::complain({"", std::string("an unexpected fault of the program: ") + error.what(),
                   "please report it with the command that led here"});
  }
  return static_cast<int>(ExitStatus::failed);
}
