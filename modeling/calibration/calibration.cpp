#include "modeling/calibration/calibration.h"

#include <algorithm>
#include <cmath>

#include "modeling/scene/build.h"
#include "sim/dynamics/simulation.h"

namespace modeling {
namespace {

// The sample: a hollow cylinder as in the paper's Fig. 3, about as large as a cup.
constexpr double kRadius = 3.0;      // cm, outside
constexpr double kHeight = 7.0;      // cm
constexpr double kWall = 0.6;        // cm
constexpr double kClearance = 0.01;  // cm above the floor at the start

/// A trial lasts this many times a wave needs from end to end: bending waves, which break thin walls, are
/// several times slower than the wave along, and cracks run on for a while.
constexpr double kCrossings = 30.0;
/// From this share of grains on, it is crumbling.
constexpr double kCrumbs = 0.25;
constexpr double kLargeShare = 0.05;
/// Thresholds tried, relative to speed / wave speed, which is the strain of a head-on impact.
constexpr double kHighest = 4.0;
constexpr double kLowest = 0.04;

double waveSpeed(const Material& material) {
  return std::sqrt(material.youngsModulus / material.density);
}

Scene sampleScene(const Material& material, const CalibrationSettings& settings, double threshold) {
  Scene scene;
  scene.name = "sample";
  Material sample = material;
  sample.threshold.mean = threshold;
  sample.strength.reset();
  sample.fractureToughness.reset();
  scene.materials.push_back({material.name, "", sample});
  RevolutionShape cylinder;
  cylinder.outside = {straightSegment(Vec2(kRadius, kHeight), Vec2(kRadius, 0.0))};
  cylinder.inside = {straightSegment(Vec2(kRadius - kWall, kHeight), Vec2(kRadius - kWall, 0.0))};
  cylinder.resolution.cellSize = settings.cellSize;
  Part part;
  part.name = "cylinder";
  part.shape = cylinder;
  part.material = material.name;
  constexpr double kDegrees = 180.0 / 3.14159265358979323846;
  part.worldFromPart.rotation.value = Vec3(0.0, settings.tilt * kDegrees, 0.0);
  part.worldFromPart.position = Vec3(0.0, 0.0, kRadius * std::sin(settings.tilt) + kClearance);
  part.velocity = Vec3(0.0, 0.0, -settings.speed);
  scene.parts.push_back(part);
  SceneCollider floor;
  floor.name = "floor";
  floor.form = FloorShape{};
  scene.environment.colliders.push_back(floor);
  scene.solver.seed = settings.seed;
  return scene;
}

void judge(Trial& trial, const sim::Snapshot& snapshot) {
  std::size_t isolated = 0;
  const auto nodes = static_cast<double>(snapshot.positions.size());
  for (const sim::Fragment& fragment : snapshot.broken->fragments) {
    if (fragment.nodeCount == 1) ++isolated;
    if (fragment.nodeCount > 1) ++trial.fragments;
    if (fragment.nodeCount >= kLargeShare * nodes) ++trial.largeFragments;
  }
  trial.isolatedShare = static_cast<double>(isolated) / nodes;
  if (trial.isolatedShare > kCrumbs || trial.largeFragments == 0) {
    trial.verdict = TrialVerdict::crumbles;
  } else if (trial.largeFragments > 1) {
    trial.verdict = TrialVerdict::breaks;
  }
}

sim::Result<Trial> drop(const Material& material, const CalibrationSettings& settings, double threshold) {
  const Scene scene = sampleScene(material, settings, threshold);
  auto built = build(scene, {});
  if (!built) return built.problem();
  built->conditions.settings.threads = settings.threads;
  auto simulation = sim::Simulation::create(std::move(built->network), built->conditions.environment, {},
                                            built->conditions.settings);
  if (!simulation) return simulation.problem();
  if (const auto done = (*simulation)->advanceTo(kCrossings * kHeight / waveSpeed(material)); !done)
    return done.problem();
  Trial trial;
  trial.threshold = threshold;
  const auto events = (*simulation)->drainBreakEvents();
  if (!events.empty()) trial.firstBreak = std::max(0.0, events.front().time - kClearance / settings.speed);
  judge(trial, (*simulation)->snapshot());
  return trial;
}

}  // namespace

const char* nameOf(TrialVerdict verdict) {
  switch (verdict) {
    case TrialVerdict::holds:
      return "holds";
    case TrialVerdict::breaks:
      return "breaks";
    case TrialVerdict::crumbles:
      return "crumbles";
  }
  return "";
}

sim::Result<Calibration> calibrate(const Material& material, const CalibrationSettings& settings,
                                   const std::function<bool(const Trial&)>& watch) {
  if (const auto usable = validate(material); !usable) return usable.problem();
  if (!(settings.speed > 0.0) || !(settings.cellSize > 0.0) || settings.trialsPerDecade < 1) {
    return sim::Problem{"calibration", "speed, cell size and trials must be above 0", ""};
  }
  const double impactStrain = settings.speed / waveSpeed(material);
  const double ratio = std::pow(10.0, -1.0 / settings.trialsPerDecade);
  Calibration calibration;
  double logarithms = 0.0;
  int breaking = 0;
  // NOLINTNEXTLINE(clang-analyzer-security.FloatLoopCounter): each trial is a share of the last.
  for (double share = kHighest; share > kLowest; share *= ratio) {
    auto trial = drop(material, settings, share * impactStrain);
    if (!trial) return trial.problem();
    calibration.trials.push_back(*trial);
    if (trial->verdict == TrialVerdict::breaks) {
      logarithms += std::log(trial->threshold);
      ++breaking;
    }
    if (!watch(*trial) || trial->verdict == TrialVerdict::crumbles) break;
  }
  if (breaking > 0) calibration.threshold = std::exp(logarithms / breaking);
  return calibration;
}

}  // namespace modeling
