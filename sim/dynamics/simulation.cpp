#include "sim/dynamics/simulation.h"

#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>

#include "sim/dynamics/stepper.h"

namespace sim {

struct Simulation::State {
  State(Network network, Environment environment, std::vector<Track> tracks, const Settings& settings)
      : stepper(std::move(network), std::move(environment), std::move(tracks), settings) {}
  Stepper stepper;
};

namespace {

std::optional<Problem> checkTrack(const Track& track, const std::string& place, std::size_t materials,
                                  std::size_t colliders) {
  const bool drivesCollider =
      track.target == TrackTarget::colliderPosition || track.target == TrackTarget::colliderRotation;
  const bool drivesMaterial =
      track.target == TrackTarget::stiffnessScale || track.target == TrackTarget::dampingScale;
  if (drivesCollider && track.object >= colliders)
    return Problem{place, "the track drives a collider that is not there", "name one of the environment's"};
  if (drivesMaterial && track.object != kNone && track.object >= materials)
    return Problem{place, "the track drives a material that is not there", "name one of the scene's"};
  if (track.keys.empty()) return Problem{place, "the track has no keys", "give it one, or leave it out"};
  for (std::size_t k = 0; k < track.keys.size(); ++k) {
    const Track::Key& key = track.keys[k];
    if (!std::isfinite(key.time) || !key.value.allFinite())
      return Problem{place, "key " + std::to_string(k) + " is not finite",
                     "give its time and value as numbers"};
    if (k > 0 && key.time <= track.keys[k - 1].time)
      return Problem{place, "key " + std::to_string(k) + " is not later than the one before",
                     "sort the keys"};
    if (drivesMaterial && key.value.x() < 0.0)
      return Problem{place, "key " + std::to_string(k) + " is a negative scale", "use 0 or more"};
  }
  return std::nullopt;
}

std::optional<Problem> checkTolerance(const Settings& settings) {
  if (!settings.tolerance) return std::nullopt;
  if (!(*settings.tolerance > 0.0 && *settings.tolerance <= 1.0))
    return Problem{"solver.step", "the tolerance is not between 0 and 1", "0.001 is a good one"};
  if (settings.step)
    return Problem{"solver.step", "there is a tolerance beside a fixed step", "give one of the two"};
  if (settings.method == Method::forwardEuler || settings.method == Method::symplecticEuler) {
    return Problem{"solver.step",
                   std::string(nameOf(settings.method)) + " has no estimate of its error to keep to",
                   "choose velocity-verlet or rk4, or give no tolerance"};
  }
  return std::nullopt;
}

std::optional<Problem> checkTracks(const Network& network, const Environment& environment,
                                   const std::vector<Track>& tracks) {
  for (std::size_t t = 0; t < tracks.size(); ++t) {
    if (auto problem = checkTrack(tracks[t], "tracks[" + std::to_string(t) + "]", network.materials.size(),
                                  environment.colliders.size()))
      return problem;
  }
  return std::nullopt;
}

/// What can't be stable is refused.
std::optional<Problem> checkStep(const Stepper& stepper, const Settings& settings) {
  if (settings.step) {
    if (*settings.step <= stepper.longestStep()) return std::nullopt;
    if (stepper.longestStep() > 0.0) {
      std::ostringstream longest;
      longest << std::setprecision(4) << stepper.longestStep();
      return Problem{"solver.step",
                     "the step is longer than " + longest.str() + " s, the longest that is stable with " +
                         std::string(nameOf(settings.method)),
                     "take a shorter one, or leave it \"auto\""};
    }
  } else if (stepper.step() > 0.0) {
    return std::nullopt;
  }
  return Problem{"solver.method",
                 "no step is stable: forward Euler gains energy wherever a bond has no damping",
                 "choose velocity-verlet, or give every material a loss factor"};
}

std::optional<Problem> checkSettings(const Network& network, const Environment& environment,
                                     const Settings& settings, const std::vector<Track>& tracks) {
  if (network.nodeCount() == 0) return Problem{"", "there is nothing to simulate", "add a part to the scene"};
  if (auto fault = network.validate()) return Problem{"", *fault, ""};
  if (network.materials.size() > 256)
    return Problem{"", "there are more than 256 materials", "share materials between parts"};
  if (settings.step && (!std::isfinite(*settings.step) || *settings.step <= 0.0)) {
    return Problem{"solver.step", "the step is not a positive number of seconds", "leave it \"auto\""};
  }
  if (auto problem = checkTolerance(settings)) return problem;
  if (!(settings.safety > 0.0 && settings.safety <= 0.9)) {
    return Problem{"solver.safety", "the safety factor is not between 0 and 0.9", "0.5 is the default"};
  }
  return checkTracks(network, environment, tracks);
}

std::optional<Problem> checkReplan(const std::vector<MovingCollider>& before,
                                   const std::vector<Collider>& colliders) {
  for (std::size_t c = 0; c < before.size(); ++c) {
    const std::string place = "environment.colliders[" + std::to_string(c) + "]";
    const std::string& name = before[c].shape.name;
    if (c >= colliders.size()) {
      return Problem{place, "the collider '" + name + "' is gone from a run that has begun",
                     "let its time to act end instead"};
    }
    if (colliders[c].shape.index() != before[c].shape.shape.index()) {
      return Problem{place, "the collider '" + name + "' has another shape in a run that has begun",
                     "add another one behind the last"};
    }
  }
  return std::nullopt;
}

bool sameNetwork(const Network& left, const Network& right) {
  return left.positions == right.positions && left.masses == right.masses && left.radii == right.radii &&
         left.firstBond == right.firstBond && left.bondEnds == right.bondEnds &&
         left.bondClasses == right.bondClasses && left.classes == right.classes &&
         left.thresholds == right.thresholds && left.cells == right.cells &&
         left.materials == right.materials;
}

}  // namespace

Simulation::Simulation(std::unique_ptr<State> state) : state_(std::move(state)) {}
Simulation::~Simulation() = default;

Result<std::unique_ptr<Simulation>> Simulation::create(Network network, Environment environment,
                                                       std::vector<Track> tracks, const Settings& settings) {
  if (auto problem = checkSettings(network, environment, settings, tracks)) return *problem;
  auto state =
      std::make_unique<State>(std::move(network), std::move(environment), std::move(tracks), settings);
  if (auto problem = checkStep(state->stepper, settings)) return *problem;
  return std::unique_ptr<Simulation>(new Simulation(std::move(state)));
}

Status Simulation::advanceTo(double until) {
  return state_->stepper.advanceTo(until);
}
Status Simulation::stepOnce() {
  return state_->stepper.stepOnce();
}
Status Simulation::replan(Environment environment, std::vector<Track> tracks) {
  if (auto problem = checkReplan(state_->stepper.controls().colliders(), environment.colliders))
    return *problem;
  if (auto problem = checkTracks(network(), environment, tracks)) return *problem;
  state_->stepper.replan(std::move(environment), std::move(tracks));
  return Done{};
}
double Simulation::time() const {
  return state_->stepper.time();
}
double Simulation::step() const {
  return state_->stepper.step();
}
StepLimit Simulation::stepLimit() const {
  return state_->stepper.stepLimit();
}
std::uint64_t Simulation::stepCount() const {
  return work().steps;
}
std::uint64_t Simulation::brokenBondCount() const {
  return state_->stepper.breakage().brokenBondCount();
}
std::uint64_t Simulation::stateHash() const {
  state_->stepper.placeAll();
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
  state_->stepper.placeAll();
  return state_->stepper.checkpoint();
}
Status Simulation::restore(std::span<const std::byte> checkpoint) {
  return state_->stepper.restore(checkpoint);
}
Status Simulation::takeOver(Simulation& other) {
  if (!sameNetwork(network(), other.network()))
    return Problem{"", "the two runs are of different networks", "run the changed one from the start"};
  state_->stepper.takeOver(other.state_->stepper);
  return Done{};
}

Snapshot Simulation::snapshot() const {
  state_->stepper.placeAll();
  const Stepper& stepper = state_->stepper;
  const Stepper::Present present = stepper.present();
  const std::size_t count = stepper.network().nodeCount();
  Snapshot snapshot;
  snapshot.time = stepper.time();
  snapshot.stepCount = stepper.work().steps;
  snapshot.positions.reserve(count);
  snapshot.velocities.reserve(count);
  for (std::size_t node = 0; node < count; ++node) {
    snapshot.positions.push_back(stepper.positions().get(node));
    snapshot.velocities.push_back(present.velocity.get(node));
  }
  snapshot.fragmentOfNode = stepper.components().fragmentOfNode();
  snapshot.brokenBonds = stepper.breakage().brokenBonds();
  snapshot.brokenCells = stepper.breakage().brokenCells();
  snapshot.fragments = describeFragments(stepper.network(), stepper.components(), snapshot);
  for (Fragment& fragment : snapshot.fragments)
    fragment.state = stepper.fragments().activity().stateOf(fragment.id);
  snapshot.ledger = stepper.drawLedger(present);
  return snapshot;
}

}  // namespace sim
