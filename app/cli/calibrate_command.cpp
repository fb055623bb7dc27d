#include <cstdio>
#include <memory>

#include "app/cli/commands.h"
#include "modeling/calibration/calibration.h"
#include "modeling/scene/resources.h"

namespace app {
namespace {

struct CalibrateOptions {
  std::string material;
  modeling::CalibrationSettings settings;
};

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

ExitStatus runCalibration(const CalibrateOptions& options) {
  const auto material = modeling::presetMaterial(options.material);
  if (!material) return complain(material.problem());
  printHead();
  const auto calibration = modeling::calibrate(*material, options.settings, printTrial);
  if (!calibration) return complain(calibration.problem(), ExitStatus::failed);
  if (!calibration->threshold) {
    return complain({"material " + options.material, "no threshold made the samples break after the impact",
                     "try another --speed"},
                    ExitStatus::failed);
  }
  std::printf("\"threshold\": {\"mean\": %.3g, \"spread\": %g}\n", *calibration->threshold,
              material->threshold.spread);
  return ExitStatus::done;
}

}  // namespace

Command calibrateCommand() {
  const auto options = std::make_shared<CalibrateOptions>();
  modeling::CalibrationSettings& settings = options->settings;
  return {.name = "calibrate",
          .help = "Finds a material's breaking threshold by dropping small cylinders of it",
          .options = {{.name = "MATERIAL",
                       .target = &options->material,
                       .help = "One of resources/materials",
                       .required = true},
                      {.name = "--speed",
                       .target = &settings.speed,
                       .help = "Of the impact, cm/s",
                       .positive = true},
                      {.name = "--cell-size",
                       .target = &settings.cellSize,
                       .help = "Of the model the threshold is for, cm",
                       .positive = true},
                      {"--seed", &settings.seed, "Of the random thresholds"},
                      {.name = "--threads",
                       .target = &settings.threads,
                       .help = "0: all there are",
                       .range = Range{0.0, 256.0}}},
          .run = [options] { return runCalibration(*options); }};
}

}  // namespace app
