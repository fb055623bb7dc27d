#include "app/cli/bench_command.h"

#include <CLI/CLI.hpp>

#include "app/bench/throughput.h"

namespace app {
namespace {

struct BenchOptions {
  std::string out;
  std::vector<int> threads;
  bool quick = false;

  std::optional<std::filesystem::path> folder() const {
    return out.empty() ? std::nullopt : std::optional<std::filesystem::path>(out);
  }
};

void addOptions(CLI::App& command, const std::shared_ptr<BenchOptions>& options) {
  command.add_option("--out", options->out, "Folder for the results as JSON");
  command.add_option("--threads", options->threads, "Threads to measure with; may be repeated")
      ->check(CLI::Range(1, 256));
}

}  // namespace

void addBenchCommand(CLI::App& program, ExitStatus& status) {
  CLI::App* bench = program.add_subcommand("bench", "Measures speed and memory");
  bench->require_subcommand(1);
  const auto options = std::make_shared<BenchOptions>();
  CLI::App* throughput = bench->add_subcommand("throughput", "Bond updates a second, beside a plain loop");
  addOptions(*throughput, options);
  throughput->callback([options, &status] {
    const std::vector<int> threads = options->threads.empty() ? std::vector<int>{1, 2} : options->threads;
    if (const auto done = benchThroughput(threads, options->folder()); !done)
      status = complain(done.problem());
  });
  CLI::App* scaling = bench->add_subcommand("scaling", "Time a step against the number of nodes");
  addOptions(*scaling, options);
  scaling->callback([options, &status] {
    const int threads = options->threads.empty() ? 1 : options->threads.front();
    if (const auto done = benchScaling(threads, options->folder()); !done) status = complain(done.problem());
  });
  CLI::App* skip = bench->add_subcommand("skip", "Scenes with and without each thing that may be left out");
  addOptions(*skip, options);
  skip->add_flag("--quick", options->quick, "Leave out what takes minutes");
  skip->callback([options, &status] {
    const int threads = options->threads.empty() ? 1 : options->threads.front();
    if (const auto done = benchSkip(threads, options->quick, options->folder()); !done)
      status = complain(done.problem());
  });
}

}  // namespace app
