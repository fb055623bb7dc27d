#include "sim/dynamics/simulation.h"

#include "sim/dynamics/checkpoint.h"
#include "sim/dynamics/checks.h"
#include "sim/dynamics/stepper.h"
#include "sim/skipping/bodies.h"

namespace sim {

struct Simulation::State {
  State(Network network, Environment environment, std::vector<Track> tracks, const Settings& settings)
      : stepper(std::move(network), std::move(environment), std::move(tracks), settings) {}

  const World& world() const { return stepper.world(); }
  /// All of this moment, to be looked at.
  World& placed() {
    placeBodies(stepper.world());
    return stepper.world();
  }
  /// Snapshots between two breaks share it. Bonds never heal, so that in one run their number tells whether
  /// anything broke; where the run becomes another one, forgetBroken() is called.
  const BrokenPointer& brokenNow() {
    const std::uint64_t bonds = world().breakage.brokenBondCount();
    if (!broken || brokenBonds != bonds) {
      broken = sealed({world().breakage.brokenBonds(), world().breakage.brokenCells(),
                       world().components.fragmentOfNode(),
                       describeFragments(world().network, world().components)});
      brokenBonds = bonds;
    }
    return broken;
  }
  void forgetBroken() { broken.reset(); }

  Stepper stepper;
  BrokenPointer broken;           ///< of the last snapshot; null before the first
  std::uint64_t brokenBonds = 0;  ///< how many there are in it
};

Simulation::Simulation(std::unique_ptr<State> state) : state_(std::move(state)) {}
Simulation::~Simulation() = default;

Result<std::unique_ptr<Simulation>> Simulation::create(Network network, Environment environment,
                                                       std::vector<Track> tracks, const Settings& settings) {
  if (auto problem = findFault(network, environment, tracks, settings)) return *problem;
  auto state =
      std::make_unique<State>(std::move(network), std::move(environment), std::move(tracks), settings);
  if (auto problem = findUnstableStep(state->stepper)) return *problem;
  return std::unique_ptr<Simulation>(new Simulation(std::move(state)));
}

Status Simulation::advanceTo(double until, const std::function<void()>& afterStep) {
  return state_->stepper.advanceTo(until, afterStep);
}
Status Simulation::stepOnce() {
  return state_->stepper.stepOnce();
}
Status Simulation::replan(Environment environment, std::vector<Track> tracks) {
  World& world = state_->stepper.world();
  if (auto problem = findFaultOfReplan(world, environment, tracks)) return *problem;
  world.controls.replan(std::move(environment), std::move(tracks));
  return Done{};
}
double Simulation::time() const {
  return state_->world().time();
}
double Simulation::step() const {
  return state_->world().clock.step;
}
std::vector<double> Simulation::stepsAt(std::span<const Pace> paces) const {
  const Stiffest now = state_->stepper.stiffestNow();
  Stiffest coiled = state_->stepper.stiffestCoil();
  coiled.raise(now);
  std::vector<double> steps;
  for (const Pace& pace : paces)
    steps.push_back(state_->stepper.stepAt(pace.time, pace.speed, pace.deforms, pace.coils ? coiled : now));
  return steps;
}
StepLimit Simulation::stepLimit() const {
  return state_->stepper.stepLimit();
}
std::uint64_t Simulation::stepCount() const {
  return work().steps;
}
std::uint64_t Simulation::brokenBondCount() const {
  return state_->world().breakage.brokenBondCount();
}
std::uint64_t Simulation::stateHash() const {
  return hashOf(state_->placed());
}
double Simulation::maxRise() const {
  return state_->world().ledger.maxRise();
}
const Work& Simulation::work() const {
  return state_->world().work;
}
std::vector<BreakEvent> Simulation::drainBreakEvents() {
  return std::exchange(state_->stepper.world().events, {});
}
const Network& Simulation::network() const {
  return state_->world().network;
}
std::size_t Simulation::memoryBytes() const {
  return state_->stepper.memoryBytes();
}
std::vector<std::byte> Simulation::checkpoint() const {
  state_->placed();
  return state_->stepper.checkpoint();
}
Status Simulation::restore(std::span<const std::byte> checkpoint) {
  state_->forgetBroken();
  return state_->stepper.restore(checkpoint);
}
Status Simulation::takeOver(Simulation& other) {
  if (!sameNetwork(network(), other.network()))
    return Problem{"", "the two runs are of different networks", "run the changed one from the start"};
  state_->forgetBroken();
  state_->stepper.takeOver(other.state_->stepper);
  return Done{};
}

Snapshot Simulation::snapshot() const {
  const World& world = state_->placed();
  const Present present = state_->stepper.present();
  const std::size_t count = world.network.nodeCount();
  Snapshot snapshot;
  snapshot.time = world.time();
  snapshot.stepCount = world.work.steps;
  snapshot.positions.reserve(count);
  snapshot.velocities.reserve(count);
  for (std::size_t node = 0; node < count; ++node) {
    snapshot.positions.push_back(world.now.position.get(node));
    snapshot.velocities.push_back(present.velocity.get(node));
  }
  snapshot.broken = state_->brokenNow();
  snapshot.fragments = describeMotion(world.network, snapshot);
  for (MovingFragment& fragment : snapshot.fragments)
    fragment.state = world.fragments.activity.stateOf(fragment.id);
  snapshot.ledger = drawAccount(world, present);
  return snapshot;
}

}  // namespace sim
