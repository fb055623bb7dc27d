#include <filesystem>
#include <memory>
#include <optional>

#include "app/bench/accuracy.h"
#include "app/bench/document.h"
#include "app/bench/stability.h"
#include "app/bench/throughput.h"
#include "app/cli/commands.h"

namespace app {
namespace {

/// The options of all benchmarks; each offers those that it heeds.
struct BenchOptions {
  std::string out;
  std::string plots;
  std::string docs = DocumentOptions{}.docs;
  std::vector<int> threads;
  std::vector<std::string> scenes;
  bool quick = false;
  bool reuse = false;

  static std::optional<std::filesystem::path> folder(const std::string& name) {
    return name.empty() ? std::nullopt : std::optional<std::filesystem::path>(name);
  }
  /// The threads of a benchmark that measures with one number of them.
  int oneThreads() const { return threads.empty() ? 1 : threads.front(); }
};

ExitStatus statusOf(const sim::Status& done) {
  return done ? ExitStatus::done : complain(done.problem());
}

std::vector<Option> resultOptions(BenchOptions& options) {
  return {{"--out", &options.out, "Folder for the results as JSON"},
          {.name = "--threads",
           .target = &options.threads,
           .help = "Threads to measure with; may be repeated",
           .range = Range{1.0, 256.0}}};
}

Command throughputCommand() {
  const auto options = std::make_shared<BenchOptions>();
  return {.name = "throughput",
          .help = "Bond updates a second, beside a plain loop",
          .options = resultOptions(*options),
          .run = [options] {
            const bool asked = !options->threads.empty();
            return statusOf(benchThroughput(asked ? options->threads : std::vector<int>{1, 2},
                                            BenchOptions::folder(options->out)));
          }};
}

Command scalingCommand() {
  const auto options = std::make_shared<BenchOptions>();
  return {.name = "scaling",
          .help = "Time a step against the number of nodes",
          .options = resultOptions(*options),
          .run = [options] {
            return statusOf(benchScaling(options->oneThreads(), BenchOptions::folder(options->out)));
          }};
}

Command skipCommand() {
  const auto options = std::make_shared<BenchOptions>();
  Command command{
      .name = "skip",
      .help = "Scenes with and without each thing that may be left out",
      .options = resultOptions(*options),
      .run = [options] {
        return statusOf(benchSkip(options->oneThreads(), options->quick, BenchOptions::folder(options->out)));
      }};
  command.options.push_back({"--quick", &options->quick, "Leave out what takes minutes"});
  return command;
}

Command accuracyCommand() {
  const auto options = std::make_shared<BenchOptions>();
  return {.name = "accuracy",
          .help = "CPU time against error, every method",
          .options = {{"--out", &options->out, "Folder for accuracy.json"},
                      {"--plots", &options->plots, "Folder for the plots"},
                      {"--scene", &options->scenes, "Only this scene; may be repeated"},
                      {"--quick", &options->quick, "Small scenes and few steps"}},
          .run = [options] {
            return statusOf(benchAccuracy({.quick = options->quick,
                                           .scenes = options->scenes,
                                           .folder = BenchOptions::folder(options->out),
                                           .plots = BenchOptions::folder(options->plots)}));
          }};
}

Command stabilityCommand() {
  const auto options = std::make_shared<BenchOptions>();
  return {.name = "stability",
          .help = "What could make a run unstable, to its extremes",
          .options = {{"--out", &options->out, "Folder for stability.json"},
                      {"--quick", &options->quick, "Only the extremes, and small"}},
          .run = [options] {
            return statusOf(benchStability(options->quick, BenchOptions::folder(options->out)));
          }};
}

Command allCommand() {
  const auto options = std::make_shared<BenchOptions>();
  return {
      .name = "all",
      .help = "Every benchmark, written into benchmarks.md",
      .options = {{"--docs", &options->docs, "Folder of benchmarks.md; results and plots go into plots/"},
                  {"--reuse", &options->reuse, "Write anew from the results there; measure nothing"},
                  {"--quick", &options->quick, "Small scenes where there are any: to try the whole"}},
      .run = [options] {
        return statusOf(benchAll({.docs = options->docs, .reuse = options->reuse, .quick = options->quick}));
      }};
}

}  // namespace

Command benchCommand() {
  return {.name = "bench",
          .help = "Measures speed and memory",
          .commands = {throughputCommand(), scalingCommand(), skipCommand(), accuracyCommand(),
                       stabilityCommand(), allCommand()}};
}

}  // namespace app
