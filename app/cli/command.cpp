#include "app/cli/command.h"

#include <algorithm>
#include <iostream>

#include "modeling/text/printable.h"

namespace app {

ExitStatus complain(const sim::Problem& problem, ExitStatus status) {
  std::string line = problem.line();
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::cerr << modeling::printable(line) << '\n';
  return status;
}

Option threadsOption(int& threads) {
  return {
      .name = "--threads", .target = &threads, .help = "0: all there are", .range = Range{0.0, kMostThreads}};
}

Option forceOption(bool& force) {
  return {"--force", &force, "Replace files that are there and are of another kind; what is read, never"};
}

void tell(const std::vector<sim::Problem>& notes) {
  for (const sim::Problem& note : notes) std::cerr << "note: " << modeling::printable(note.line()) << '\n';
}

}  // namespace app
