#include "app/cli/calibrate_command.h"

#include <cstdio>

#include <CLI/CLI.hpp>

#include "modeling/calibration/calibration.h"
#include "modeling/scene/resources.h"

namespace app {
namespace {

void printHead() {
  std::printf("%12s %20s %10s %16s %15s  %s\n", "threshold", "first break (ms)", "fragments",
              "large fragments", "isolated nodes", "verdict");
}

bool printTrial(const modeling::Trial& trial) {
  char when[32] = "-";
  if (trial.firstBreak) std::snprintf(when, sizeof when, "%.3f", 1e3 * *trial.firstBreak);
  std::printf("%12.3g %20s %10zu %16zu %14.1f%%  %s\n", trial.threshold, when, trial.fragments,
              trial.largeFragments, 100.0 * trial.isolatedShare, nameOf(trial.verdict));
  std::fflush(stdout);
  return true;
}

ExitStatus runCalibration(const std::string& name, const modeling::CalibrationSettings& settings) {
  const auto material = modeling::presetMaterial(name);
  if (!material) return complain(material.problem());
  printHead();
  const auto calibration = modeling::calibrate(*material, settings, printTrial);
  if (!calibration) return complain(calibration.problem(), ExitStatus::failed);
  if (!calibration->threshold) {
    return complain(
        {"material " + name, "no threshold made the samples break after the impact", "try another --speed"},
        ExitStatus::failed);
  }
  std::printf("\"threshold\": {\"mean\": %.3g, \"spread\": %g}\n", *calibration->threshold,
              material->threshold.spread);
  return ExitStatus::done;
}

}  // namespace

void addCalibrateCommand(CLI::App& program, ExitStatus& status) {
  CLI::App* command = program.add_subcommand(
      "calibrate", "Finds a material's breaking threshold by dropping small cylinders of it");
  struct Options {
    std::string material;
    modeling::CalibrationSettings settings;
  };
  const auto options = std::make_shared<Options>();
  command->add_option("MATERIAL", options->material, "One of resources/materials")->required();
  command->add_option("--speed", options->settings.speed, "Of the impact, cm/s")->check(CLI::PositiveNumber);
  command->add_option("--cell-size", options->settings.cellSize, "Of the model the threshold is for, cm")
      ->check(CLI::PositiveNumber);
  command->add_option("--seed", options->settings.seed, "Of the random thresholds");
  command->add_option("--threads", options->settings.threads, "0: all there are")->check(CLI::Range(0, 256));
  command->callback([options, &status] { status = runCalibration(options->material, options->settings); });
}

}  // namespace app
