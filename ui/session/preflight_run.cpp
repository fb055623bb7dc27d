#include "ui/session/preflight_run.h"

#include <chrono>
#include <cmath>
#include <mutex>

#include "sim/dynamics/simulation.h"

namespace ui {

struct PreflightRun::Shared {
  mutable std::mutex mutex;
  bool done = false;
  std::optional<Preflight> result;
  std::optional<sim::Problem> problem;
};

namespace {

/// Enough to time a step by, and short enough not to be waited for.
constexpr double kTimedSeconds = 0.5;
constexpr int kMostTimedSteps = 2000;
/// Of a recorded frame, compressed (docs/formats.md).
constexpr double kBytesANode = 38.0;
constexpr double kBytesABond = 0.1;

std::size_t bondsBreakingAtRest(const sim::Network& network) {
  std::size_t count = 0;
  for (sim::NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (sim::BondIndex b = network.firstBond[a]; b < network.firstBond[a + 1]; ++b) {
      const double length = (network.positions[network.bondEnds[b]] - network.positions[a]).norm();
      if (length > (1.0 + network.thresholds[b]) * network.bond(b).restLength) ++count;
    }
  }
  return count;
}

double secondsPerStep(sim::Simulation& simulation, const std::stop_token& stop) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  const auto passed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  int steps = 0;
  while (steps < kMostTimedSteps && passed() < kTimedSeconds && !stop.stop_requested()) {
    if (!simulation.stepOnce()) break;
    ++steps;
  }
  return passed() / std::max(steps, 1);
}

sim::Result<Preflight> measure(const Preview& preview, const std::stop_token& stop) {
  const sim::Network& network = preview.built->network;
  Preflight flight;
  flight.nodes = network.nodeCount();
  flight.bonds = network.bondCount();
  flight.cells = network.cellCount();
  flight.bondsBreakingAtRest = bondsBreakingAtRest(network);
  const modeling::Conditions& conditions = preview.built->conditions;
  sim::Settings settings = conditions.settings;
  const std::optional<double> fixed = settings.step;
  settings.step.reset();
  auto simulation = sim::Simulation::create(network, conditions.environment, conditions.tracks, settings);
  if (!simulation) return simulation.problem();
  flight.stableStep = (*simulation)->step();
  flight.step = fixed.value_or(flight.stableStep);
  const modeling::Output& output = preview.scene.output;
  flight.steps = std::ceil(output.duration / flight.step);
  flight.memoryBytes = (*simulation)->memoryBytes();
  flight.clockForSecond = secondsPerStep(**simulation, stop) / flight.step;
  flight.clockForRun = flight.clockForSecond * output.duration;
  const double frames = std::floor(std::min(output.duration * output.fps, flight.steps)) + 1.0;
  flight.takeBytes = frames * (kBytesANode * static_cast<double>(flight.nodes) +
                               kBytesABond * static_cast<double>(flight.bonds));
  return flight;
}

}  // namespace

PreflightRun::~PreflightRun() {
  runner_.request_stop();
  // Finding the stable step of something large takes longer than a person waits for a window to close; what
  // it works on is its own.
  if (runner_.joinable() && !isDone()) runner_.detach();
}

void PreflightRun::start(const std::shared_ptr<const Preview>& preview) {
  runner_.request_stop();
  if (runner_.joinable()) runner_.detach();
  shared_ = std::make_shared<Shared>();
  runner_ = std::jthread([shared = shared_, preview](const std::stop_token& stop) {
    sim::Result<Preflight> result = sim::Problem{"", "there is nothing to simulate", "add a part"};
    try {
      if (preview->problem) result = *preview->problem;
      if (preview->built) result = measure(*preview, stop);
    } catch (const std::exception& exception) {
      result = sim::Problem{"", std::string("this could not be found out: ") + exception.what(), ""};
    }
    const std::lock_guard lock(shared->mutex);
    shared->done = true;
    if (result) {
      shared->result = *result;
    } else {
      shared->problem = result.problem();
    }
  });
}

bool PreflightRun::isDone() const {
  if (!shared_) return false;
  const std::lock_guard lock(shared_->mutex);
  return shared_->done;
}

std::optional<Preflight> PreflightRun::result() const {
  if (!shared_) return std::nullopt;
  const std::lock_guard lock(shared_->mutex);
  return shared_->result;
}

std::optional<sim::Problem> PreflightRun::problem() const {
  if (!shared_) return std::nullopt;
  const std::lock_guard lock(shared_->mutex);
  return shared_->problem;
}

}  // namespace ui
