#include "sim/dynamics/simulation.h"

#include <cmath>
#include <limits>

#include "sim/dynamics/stepper.h"

namespace sim {

struct Simulation::State {
  State(Network network, Environment environment, std::vector<Track> tracks, const Settings& settings)
      : stepper(std::move(network), std::move(environment), std::move(tracks), settings) {}
  Stepper stepper;
};

namespace {

std::optional<Problem> checkSettings(const Network& network, const Settings& settings,
                                     const std::vector<Track>& tracks) {
  if (network.nodeCount() == 0) return Problem{"", "there is nothing to simulate", "add a part to the scene"};
  if (auto fault = network.validate()) return Problem{"", *fault, ""};
  if (network.materials.size() > 256)
    return Problem{"", "there are more than 256 materials", "share materials between parts"};
  if (settings.step && (!std::isfinite(*settings.step) || *settings.step <= 0.0)) {
    return Problem{"solver.step", "the step is not a positive number of seconds", "leave it \"auto\""};
  }
  if (!(settings.safety > 0.0 && settings.safety <= 0.9)) {
    return Problem{"solver.safety", "the safety factor is not between 0 and 0.9", "0.5 is the default"};
  }
  for (const Track& track : tracks) {
    if (track.keys.empty()) return Problem{"tracks", "a track has no keys", "give it one, or leave it out"};
  }
  return std::nullopt;
}

}  // namespace

Simulation::Simulation(std::unique_ptr<State> state) : state_(std::move(state)) {}
Simulation::~Simulation() = default;

Result<std::unique_ptr<Simulation>> Simulation::create(Network network, Environment environment,
                                                       std::vector<Track> tracks, const Settings& settings) {
  if (auto problem = checkSettings(network, settings, tracks)) return *problem;
  auto state =
      std::make_unique<State>(std::move(network), std::move(environment), std::move(tracks), settings);
  if (!(state->stepper.step() > 0.0)) {
    return Problem{"solver.method",
                   "no step is stable: forward Euler gains energy wherever a bond has no damping",
                   "choose velocity-verlet, or give every material a loss factor"};
  }
  return std::unique_ptr<Simulation>(new Simulation(std::move(state)));
}

Status Simulation::advanceTo(double until) {
  return state_->stepper.advanceTo(until);
}
Status Simulation::stepOnce() {
  return state_->stepper.stepOnce();
}
double Simulation::time() const {
  return state_->stepper.time();
}
double Simulation::step() const {
  return state_->stepper.step();
}
std::uint64_t Simulation::stepCount() const {
  return work().steps;
}
std::uint64_t Simulation::brokenBondCount() const {
  return state_->stepper.breakage().brokenBondCount();
}
std::uint64_t Simulation::stateHash() const {
  return state_->stepper.stateHash();
}
double Simulation::maxRise() const {
  return state_->stepper.maxRise();
}
const Work& Simulation::work() const {
  return state_->stepper.work();
}
std::vector<BreakEvent> Simulation::drainBreakEvents() {
  return state_->stepper.drainEvents();
}
const Network& Simulation::network() const {
  return state_->stepper.network();
}
std::size_t Simulation::memoryBytes() const {
  return state_->stepper.memoryBytes();
}
std::vector<std::byte> Simulation::checkpoint() const {
  return state_->stepper.checkpoint();
}
Status Simulation::restore(std::span<const std::byte> checkpoint) {
  return state_->stepper.restore(checkpoint);
}

Snapshot Simulation::snapshot() const {
  const Stepper& stepper = state_->stepper;
  const NodeVectors velocities = stepper.velocitiesNow();
  const std::size_t count = stepper.network().nodeCount();
  Snapshot snapshot;
  snapshot.time = stepper.time();
  snapshot.stepCount = stepper.work().steps;
  snapshot.positions.reserve(count);
  snapshot.velocities.reserve(count);
  for (std::size_t node = 0; node < count; ++node) {
    snapshot.positions.push_back(stepper.positions().get(node));
    snapshot.velocities.push_back(velocities.get(node));
  }
  snapshot.fragmentOfNode = stepper.components().fragmentOfNode();
  snapshot.brokenBonds = stepper.breakage().brokenBonds();
  snapshot.brokenCells = stepper.breakage().brokenCells();
  snapshot.fragments = describeFragments(stepper.network(), stepper.components(), snapshot);
  snapshot.ledger = stepper.drawLedger(velocities);
  return snapshot;
}

}  // namespace sim
