#include <filesystem>
#include <memory>
#include <optional>

#include "app/bench/accuracy.h"
#include "app/bench/contact.h"
#include "app/bench/document.h"
#include "app/bench/stability.h"
#include "app/bench/throughput.h"
#include "app/cli/commands.h"
#include "modeling/files/output_guard.h"

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
  bool force = false;

  static std::optional<std::filesystem::path> folder(const std::string& name) {
    return name.empty() ? std::nullopt : std::optional<std::filesystem::path>(name);
  }
  /// The threads of a benchmark that measures with one number of them.
  int oneThreads() const { return threads.empty() ? 1 : threads.front(); }

  /// Whether results of that name may be written into --out, and plots into --plots.
  sim::Status check(const std::string& name) const {
    modeling::OutputGuard guard(force);
    if (!out.empty()) guard.writes(std::filesystem::path(out) / (name + ".json"), modeling::kinds::table);
    if (!plots.empty()) addPlots(plots, guard);
    return guard.check();
  }
  /// Whether all that `bench all` writes may be.
  sim::Status checkAll() const {
    modeling::OutputGuard guard(force);
    const std::filesystem::path folder = docs;
    guard.writes(folder / "benchmarks.md", modeling::kinds::benchmarks);
    for (const char* name : {"throughput", "scaling", "accuracy", "stability", "contact", "skip"})
      guard.writes(folder / "plots" / (std::string(name) + ".json"), modeling::kinds::table);
    addPlots(folder / "plots", guard);
    return guard.check();
  }

 private:
  /// Which there will be is known when they are measured: those that are there already.
  static void addPlots(const std::filesystem::path& folder, modeling::OutputGuard& guard) {
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
      if (!entry.path().filename().string().starts_with("accuracy-")) continue;
      if (entry.path().extension() == ".png") guard.writes(entry.path(), modeling::kinds::png);
      if (entry.path().extension() == ".svg") guard.writes(entry.path(), modeling::kinds::svg);
    }
  }
};

/// Measures, where what it leaves spoils nothing.
ExitStatus measured(const sim::Status& safe, const std::function<sim::Status()>& measure) {
  const sim::Status done = safe ? measure() : safe;
  return done ? ExitStatus::done : complain(done.problem());
}

std::vector<Option> resultOptions(BenchOptions& options) {
  return {{"--out", &options.out, "Folder for the results as JSON"},
          {.name = "--threads",
           .target = &options.threads,
           .help = "Threads to measure with; may be repeated",
           .range = Range{1.0, 256.0}},
          forceOption(options.force)};
}

Command throughputCommand() {
  const auto options = std::make_shared<BenchOptions>();
  return {.name = "throughput",
          .help = "Bond updates a second, beside a plain loop",
          .options = resultOptions(*options),
          .run = [options] {
            const bool asked = !options->threads.empty();
            return measured(options->check("throughput"), [&] {
              return benchThroughput(asked ? options->threads : std::vector<int>{1, 2},
                                     BenchOptions::folder(options->out));
            });
          }};
}

Command scalingCommand() {
  const auto options = std::make_shared<BenchOptions>();
  return {.name = "scaling",
          .help = "Time a step against the number of nodes",
          .options = resultOptions(*options),
          .run = [options] {
            return measured(options->check("scaling"), [&] {
              return benchScaling(options->oneThreads(), BenchOptions::folder(options->out));
            });
          }};
}

Command skipCommand() {
  const auto options = std::make_shared<BenchOptions>();
  Command command{.name = "skip",
                  .help = "Scenes with and without each thing that may be left out",
                  .options = resultOptions(*options),
                  .run = [options] {
                    return measured(options->check("skip"), [&] {
                      return benchSkip(options->oneThreads(), options->quick,
                                       BenchOptions::folder(options->out));
                    });
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
                      {"--quick", &options->quick, "Small scenes and few steps"},
                      forceOption(options->force)},
          .run = [options] {
            return measured(options->check("accuracy"), [&] {
              return benchAccuracy({.quick = options->quick,
                                    .scenes = options->scenes,
                                    .folder = BenchOptions::folder(options->out),
                                    .plots = BenchOptions::folder(options->plots)});
            });
          }};
}

Command stabilityCommand() {
  const auto options = std::make_shared<BenchOptions>();
  return {.name = "stability",
          .help = "What could make a run unstable, to its extremes",
          .options = {{"--out", &options->out, "Folder for stability.json"},
                      {"--quick", &options->quick, "Only the extremes, and small"},
                      forceOption(options->force)},
          .run = [options] {
            return measured(options->check("stability"), [&] {
              return benchStability(options->quick, BenchOptions::folder(options->out));
            });
          }};
}

Command contactCommand() {
  const auto options = std::make_shared<BenchOptions>();
  return {.name = "contact",
          .help = "How bodies touch, by surfaces and by nodes",
          .options = {{"--out", &options->out, "Folder for contact.json"},
                      {"--quick", &options->quick, "Leave out what takes more than some seconds"},
                      forceOption(options->force)},
          .run = [options] {
            return measured(options->check("contact"),
                            [&] { return benchContact(options->quick, BenchOptions::folder(options->out)); });
          }};
}

Command allCommand() {
  const auto options = std::make_shared<BenchOptions>();
  return {.name = "all",
          .help = "Every benchmark, written into benchmarks.md",
          .options = {{"--docs", &options->docs, "Folder of benchmarks.md; results and plots go into plots/"},
                      {"--reuse", &options->reuse, "Write anew from the results there; measure nothing"},
                      {"--quick", &options->quick, "Small scenes where there are any: to try the whole"},
                      forceOption(options->force)},
          .run = [options] {
            return measured(options->checkAll(), [&] {
              return benchAll({.docs = options->docs, .reuse = options->reuse, .quick = options->quick});
            });
          }};
}

}  // namespace

Command benchCommand() {
  return {.name = "bench",
          .help = "Measures speed and memory",
          .commands = {throughputCommand(), scalingCommand(), skipCommand(), accuracyCommand(),
                       stabilityCommand(), contactCommand(), allCommand()}};
}

}  // namespace app
