#include "modeling/preflight/preflight.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "modeling/preflight/step_count.h"
#include "modeling/shapes/quality.h"
#include "sim/base/process_memory.h"
#include "sim/methods/method_table.h"
#include "sim/network/wedge.h"
#include "sim/take/frame_times.h"

namespace modeling {
namespace {

/// Enough to measure a step by, and short enough not to be waited for.
constexpr double kMeasuredSeconds = 0.2;
constexpr std::uint64_t kMostMeasuredSteps = 2000;
/// Positions and velocities of what vibrates, compressed (docs/formats.md, "Frame").
constexpr double kFrameBytesPerNode = 38.0;

const sim::Problem kStopped{"", "it was stopped before it was done", ""};

double wallClock() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

std::string partOf(const sim::Network& network, sim::NodeIndex node) {
  return network.partNames[network.nodeParts[node]];
}

void listBrokenAtRest(const sim::Network& network, Preflight& found) {
  std::vector<BrokenAtRest> all;
  for (sim::NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (sim::BondIndex b = network.firstBond[a]; b < network.firstBond[a + 1]; ++b) {
      const double length = (network.positions[network.bondEnds[b]] - network.positions[a]).norm();
      const double strain = length / network.bond(b).restLength - 1.0;
      const double threshold = network.thresholds[b];
      if (strain > threshold) all.push_back({b, partOf(network, a), strain, threshold});
    }
  }
  found.brokenAtRestCount = all.size();
  std::ranges::stable_sort(all, std::greater<>(),
                           [](const BrokenAtRest& bond) { return bond.strain - bond.threshold; });
  all.resize(std::min(all.size(), Preflight::kMostListed));
  found.brokenAtRest = std::move(all);
}

void listWorstCells(const sim::Network& network, Preflight& found) {
  struct Measured {
    sim::CellIndex cell;
    double scaledJacobian, aspect;
    double quality() const { return scaledJacobian / aspect; }
  };
  std::vector<Measured> all;
  for (sim::CellIndex cell = 0; cell < network.cellCount(); ++cell) {
    if (sim::isWedge(network.cells[cell])) continue;
    const CornerPositions corners = cornerPositions(network.positions, network.cells[cell]);
    all.push_back({cell, scaledJacobian(corners), cellAspect(corners)});
  }
  std::ranges::stable_sort(all, {}, &Measured::quality);
  all.resize(std::min(all.size(), Preflight::kMostListed));
  for (const Measured& poor : all) {
    const std::string part = partOf(network, network.cells[poor.cell][0]);
    found.worstCells.push_back({poor.cell, part, poor.scaledJacobian, poor.aspect});
  }
}

/// Steps that were made, on the average.
struct MeasuredStep {
  double wallSeconds = 0.0;
  double length = 0.0;  ///< s, of animation
};

/// Nothing when it was stopped. A blow-up ends the measuring only.
std::optional<MeasuredStep> measureStep(sim::Simulation& simulation, const std::function<bool()>& keepGoing) {
  const double start = wallClock();
  const double begin = simulation.time();
  std::uint64_t steps = 0;
  do {
    if (keepGoing && !keepGoing()) return std::nullopt;
    ++steps;
  } while (simulation.stepOnce() && wallClock() - start < kMeasuredSeconds && steps < kMostMeasuredSteps);
  const auto count = static_cast<double>(steps);
  return MeasuredStep{(wallClock() - start) / count, (simulation.time() - begin) / count};
}

/// Steps in which all deforms, as after the first landing.
sim::Result<MeasuredStep> measureDeforming(const BuiltScene& built, sim::Settings settings,
                                           const std::function<bool()>& keepGoing) {
  settings.skip = {.sleep = false, .rigid = false};
  auto simulation =
      sim::Simulation::create(built.network, built.conditions.environment, built.conditions.tracks, settings);
  if (!simulation) return simulation.problem();
  const std::optional<MeasuredStep> measured = measureStep(**simulation, keepGoing);
  if (!measured) return kStopped;
  return *measured;
}

void estimateTake(const sim::Simulation& simulation, Preflight& found) {
  const double checkpoints = std::floor(found.frames / sim::kFramesPerCheckpoint) + 1.0;
  found.takeBytes = found.frames * kFrameBytesPerNode * static_cast<double>(found.nodes) +
                    checkpoints * static_cast<double>(simulation.checkpoint().size()) +
                    static_cast<double>(simulation.network().memoryBytes());
}

}  // namespace

sim::Result<Preflight> preflight(const Scene& scene, const BuiltScene& built, int threads,
                                 const std::function<bool()>& keepGoing) {
  Preflight found;
  found.nodes = built.network.nodeCount();
  found.bonds = built.network.bondCount();
  found.cells = built.network.cellCount();
  listBrokenAtRest(built.network, found);
  listWorstCells(built.network, found);
  found.overlaps = findOverlaps(built, keepGoing);
  if (keepGoing && !keepGoing()) return kStopped;
  sim::Settings settings = built.conditions.settings;
  settings.threads = threads;
  settings.step.reset();
  auto simulation =
      sim::Simulation::create(built.network, built.conditions.environment, built.conditions.tracks, settings);
  if (!simulation) return simulation.problem();
  if (keepGoing && !keepGoing()) return kStopped;
  found.components = (*simulation)->snapshot().fragments.size();
  found.stableStep = (*simulation)->step();
  found.stableStepLimit = (*simulation)->stepLimit();
  found.step = scene.solver.step.seconds.value_or(found.stableStep);
  const StepCount count = expectedSteps(**simulation, built.conditions.environment, built.conditions.tracks,
                                        settings.skip.rigid, scene.output.duration);
  found.steps = scene.solver.step.seconds ? std::ceil(scene.output.duration / found.step) : count.all;
  found.frames = std::floor(std::min(scene.output.duration * scene.output.fps, found.steps)) + 1.0;
  const std::optional<MeasuredStep> present = measureStep(**simulation, keepGoing);
  if (!present) return kStopped;
  const sim::Result<MeasuredStep> deforming = measureDeforming(built, settings, keepGoing);
  if (!deforming) return deforming.problem();
  // Methods that solve for a step take shorter ones where they must, which nobody knows before.
  if (sim::recordOf(settings.method).implicit && deforming->length > 0.0)
    found.steps = std::max(found.steps, std::ceil(scene.output.duration / deforming->length));
  found.stepsPerSecond = scene.output.duration > 0.0 ? found.steps / scene.output.duration : 1.0 / found.step;
  const double rigidShare = count.all > 0.0 ? count.rigid / count.all : 0.0;
  const double mean = rigidShare * std::min(present->wallSeconds, deforming->wallSeconds) +
                      (1.0 - rigidShare) * deforming->wallSeconds;
  found.wallSecondsPerSecond = found.stepsPerSecond * mean;
  found.wallSeconds = found.steps * mean;
  estimateTake(**simulation, found);
  // What the system counts, since what is asked of it is more than what is used: containers have room to
  // grow, and what was freed stays with the program.
  found.memoryBytes = std::max(sim::residentMemory(), (*simulation)->memoryBytes());
  found.peakMemoryBytes = std::max(sim::peakMemory(), found.memoryBytes);
  return found;
}

}  // namespace modeling
