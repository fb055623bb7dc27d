#include "app/cli/bench_command.h"

#include <CLI/CLI.hpp>

#include "app/bench/accuracy.h"
#include "app/bench/document.h"
#include "app/bench/stability.h"
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

void addAccuracy(CLI::App& bench, ExitStatus& status) {
  CLI::App* command = bench.add_subcommand("accuracy", "CPU time against error, every method");
  const auto options = std::make_shared<AccuracyOptions>();
  command->add_option("--out", options->folder, "Folder for accuracy.json");
  command->add_option("--plots", options->plots, "Folder for the plots");
  command->add_option("--scene", options->scenes, "Only this scene; may be repeated");
  command->add_flag("--quick", options->quick, "Small scenes and few steps");
  command->callback([options, &status] {
    if (const auto done = benchAccuracy(*options); !done) status = complain(done.problem());
  });
}

void addStability(CLI::App& bench, ExitStatus& status) {
  CLI::App* command = bench.add_subcommand("stability", "What could make a run unstable, to its extremes");
  const auto options = std::make_shared<BenchOptions>();
  command->add_option("--out", options->out, "Folder for stability.json");
  command->add_flag("--quick", options->quick, "Only the extremes, and small");
  command->callback([options, &status] {
    if (const auto done = benchStability(options->quick, options->folder()); !done)
      status = complain(done.problem());
  });
}

void addAll(CLI::App& bench, ExitStatus& status) {
  CLI::App* command = bench.add_subcommand("all", "Every benchmark, written into benchmarks.md");
  const auto options = std::make_shared<DocumentOptions>();
  command->add_option("--docs", options->docs, "Folder of benchmarks.md; results and plots go into plots/");
  command->add_flag("--reuse", options->reuse, "Write anew from the results there; measure nothing");
  command->add_flag("--quick", options->quick, "Small scenes where there are any: to try the whole");
  command->callback([options, &status] {
    if (const auto done = benchAll(*options); !done) status = complain(done.problem());
  });
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
  addAccuracy(*bench, status);
  addStability(*bench, status);
  addAll(*bench, status);
}

}  // namespace app
