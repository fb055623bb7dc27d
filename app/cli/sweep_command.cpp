#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <thread>

#include "app/cli/child_processes.h"
#include "app/cli/commands.h"
#include "app/cli/progress.h"
#include "app/cli/sweep_grid.h"
#include "app/cli/sweep_results.h"
#include "modeling/files/output_file.h"
#include "modeling/files/output_guard.h"
#include "modeling/scene/scene_file.h"
#include "modeling/scene/scene_files.h"
#include "modeling/text/printable.h"
#include "modeling/text/text_output.h"

namespace app {

namespace {

namespace fs = std::filesystem;

struct SweepOptions {
  std::string scene;
  std::vector<std::string> variations;
  std::vector<std::string> settings;
  std::string out;
  std::uint64_t jobs = 1;
  std::optional<std::uint64_t> only;
  bool collect = false;
  bool slurm = false;
  bool force = false;
};

std::vector<std::string> simulateWords(const SweepOptions& options, const SweepGrid& grid, std::size_t run,
                                       std::size_t threads) {
  const SweepFiles files(options.out, run);
  std::vector<std::string> words{ownProgram(),
                                 "simulate",
                                 fs::absolute(options.scene).string(),
                                 "--take",
                                 files.take.string(),
                                 "--report",
                                 files.report.string(),
                                 "--threads",
                                 std::to_string(threads)};
  if (options.force) words.emplace_back("--force");
  for (const std::string& setting : options.settings) words.insert(words.end(), {"--set", setting});
  const auto values = grid.valuesOf(run);
  for (std::size_t v = 0; v < values.size(); ++v)
    words.insert(words.end(), {"--set", grid.variations()[v].path + "=" + values[v]});
  return words;
}

/// Every setting is tried before anything runs: a slip is told at once, not by each run.
sim::Status checkRuns(const SweepOptions& options, const SweepGrid& grid) {
  bool told = false;
  for (std::size_t v = 0; v < grid.variations().size(); ++v) {
    for (const std::string& value : grid.variations()[v].values) {
      std::vector<std::string> settings = options.settings;
      settings.push_back(grid.variations()[v].path + "=" + value);
      const auto scene = modeling::loadScene(options.scene, settings);
      if (!scene) return scene.problem();
      if (!told) tell(scene->notes);
      told = true;
    }
  }
  return sim::Done{};
}

/// Of the runs and of what is made of them, whichever of it this command writes.
sim::Status checkOutputs(const SweepOptions& options, const SweepGrid& grid) {
  const fs::path out = options.out;
  modeling::OutputGuard guard(options.force);
  guard.reads(options.scene);
  if (const auto file = modeling::loadScene(options.scene))
    guard.reads(modeling::filesOf(file->scene, fs::path(options.scene).parent_path()));
  for (std::size_t run = 0; run < grid.runs() && !options.collect && !options.slurm; ++run) {
    if (options.only && *options.only != run) continue;
    const SweepFiles files(out, run);
    guard.writes(files.take, modeling::kinds::take);
    guard.writes(files.report, modeling::kinds::report);
    guard.writes(files.log, modeling::kinds::log);
  }
  if (options.slurm) guard.writes(out / "sweep.slurm", modeling::kinds::slurm);
  if (options.slurm || options.only) return guard.check();
  guard.writes(out / "sweep.json", modeling::kinds::table);
  guard.writes(out / "sweep.csv", modeling::kinds::csv);
  guard.writes(out / "sweep.png", modeling::kinds::png);
  return guard.check();
}

/// The log begins with what it is of, so that it is known for one.
void beginLog(const ChildProcess& process) {
  std::string head = "# smithereens-cli";
  for (std::size_t word = 1; word < process.words.size(); ++word) head += " " + process.words[word];
  static_cast<void>(modeling::replaceFile(process.log, head + "\n"));
}

/// The signal that ended it early, or 0.
int runAll(const SweepOptions& options, const SweepGrid& grid) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t threads = std::max<std::size_t>(1, cores / options.jobs);
  std::vector<ChildProcess> processes;
  for (std::size_t run = 0; run < grid.runs(); ++run) {
    if (options.only && *options.only != run) continue;
    // What an earlier sweep left would be taken for this one's.
    std::error_code error;
    fs::remove(SweepFiles(options.out, run).report, error);
    processes.push_back(
        {simulateWords(options, grid, run, threads), SweepFiles(options.out, run).log.string()});
  }
  for (const ChildProcess& process : processes) beginLog(process);
  Progress progress("sweep");
  std::size_t ended = 0;
  const int signal = runChildProcesses(processes, options.jobs, [&](std::size_t, int) {
    progress.show(static_cast<double>(++ended) / static_cast<double>(processes.size()));
  });
  if (signal != 0) {
    tell({{"",
           "the sweep was stopped; " + std::to_string(ended) + " of " + std::to_string(processes.size()) +
               " runs had ended, and what they left stays",
           "--collect makes the table and the pictures of them"}});
  }
  return signal;
}

std::string inShellQuotes(const std::string& word) {
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
}

/// A task of the array is a run; what they left is collected when all have ended.
sim::Status writeSlurm(const SweepOptions& options, const SweepGrid& grid) {
  std::string sweep = inShellQuotes(ownProgram()) + " sweep " +
                      inShellQuotes(fs::absolute(options.scene).string()) + " --out " +
                      inShellQuotes(fs::absolute(options.out).string());
  for (const std::string& variation : options.variations) sweep += " --vary " + inShellQuotes(variation);
  for (const std::string& setting : options.settings) sweep += " --set " + inShellQuotes(setting);
  if (options.force) sweep += " --force";
  modeling::TextOutput out(fs::path(options.out) / "sweep.slurm");
  out << "#!/bin/bash\n#SBATCH --job-name=smithereens-sweep\n#SBATCH --array=0-"
      << std::uint64_t{grid.runs() - 1} << "\n#SBATCH --ntasks=1\n#SBATCH --cpus-per-task=1\n"
      << "# sbatch sweep.slurm; when all tasks have ended, for the table and the sheet:\n# " << sweep
      << " --collect\n"
      << sweep << " --only \"$SLURM_ARRAY_TASK_ID\"\n";
  return out.finish();
}

ExitStatus sweep(const SweepOptions& options) {
  const auto grid = SweepGrid::create(options.variations);
  if (!grid) return complain(grid.problem());
  if (options.only && *options.only >= grid->runs()) {
    return complain({"--only", "there is no run " + std::to_string(*options.only),
                     "the last one is " + std::to_string(grid->runs() - 1)});
  }
  if (const auto status = checkRuns(options, *grid); !status) return complain(status.problem());
  if (const auto safe = checkOutputs(options, *grid); !safe) return complain(safe.problem());
  std::error_code error;
  fs::create_directories(options.out, error);
  if (error) return complain({options.out, "cannot make this folder", "choose one that can be written"});
  if (options.slurm) {
    const auto written = writeSlurm(options, *grid);
    if (!written) return complain(written.problem());
    std::cout << "runs          " << grid->runs() << "\nscript        " << modeling::printable(options.out)
              << "/sweep.slurm\n";
    return ExitStatus::done;
  }
  if (const int signal = options.collect ? 0 : runAll(options, *grid); signal != 0) {
    endBySignal(signal);
    return ExitStatus::failed;
  }
  if (options.only) return ExitStatus::done;
  const auto failed = collectResults(*grid, options.out);
  if (!failed) return complain(failed.problem());
  const std::string folder = modeling::printable(options.out);
  std::cout << "runs          " << grid->runs() << ", " << *failed << " of them failed\ntable         "
            << folder << "/sweep.csv, sweep.json\npictures      " << folder << "/sweep.png\n";
  return *failed == 0 ? ExitStatus::done : ExitStatus::failed;
}

}  // namespace

Command sweepCommand() {
  const auto options = std::make_shared<SweepOptions>();
  return {.name = "sweep",
          .help = "Run a scene with every combination of values; a table and a sheet of pictures",
          .options = {{.name = "scene", .target = &options->scene, .help = "The scene", .required = true},
                      {.name = "--vary",
                       .target = &options->variations,
                       .help = "PATH=A,B,C; may be given several times",
                       .required = true},
                      {"--set", &options->settings, "PATH=VALUE for all runs"},
                      {.name = "--out",
                       .target = &options->out,
                       .help = "Folder for takes, reports, table and pictures",
                       .required = true},
                      {.name = "--jobs",
                       .target = &options->jobs,
                       .help = "Runs at a time",
                       .range = Range{1.0, kMostThreads}},
                      {"--only", &options->only, "Only the run of this number, from 0; no table"},
                      {"--collect", &options->collect, "Table and pictures of runs that have ended"},
                      {"--slurm", &options->slurm, "Write a job array for Slurm instead of running"},
                      forceOption(options->force)},
          .run = [options] { return sweep(*options); }};
}

}  // namespace app
