#include "sim/dynamics/checks.h"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace sim {
namespace {

std::optional<Problem> checkTrack(const Track& track, const std::string& place, std::size_t materials,
                                  std::size_t colliders) {
  const bool ofMaterial = scalesMaterial(track.target);
  if (drivesCollider(track.target) && track.object >= colliders)
    return Problem{place, "the track drives a collider that is not there", "name one of the environment's"};
  if (ofMaterial && track.object != kNone && track.object >= materials)
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
    if (ofMaterial && key.value.x() < 0.0)
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

}  // namespace

std::optional<Problem> findUnstableStep(const Stepper& stepper) {
  const Settings& settings = stepper.world().settings;
  if (settings.step) {
    const double most = stepper.length().longestFixed();
    if (*settings.step <= most) return std::nullopt;
    if (most > 0.0) {
      std::ostringstream longest;
      longest << std::setprecision(4) << most;
      return Problem{"solver.step",
                     "the step is longer than " + longest.str() + " s, the longest that is stable with " +
                         std::string(nameOf(settings.method)),
                     "take a shorter one, or leave it \"auto\""};
    }
  } else if (stepper.world().clock.step > 0.0) {
    return std::nullopt;
  }
  return Problem{"solver.method",
                 "no step is stable: forward Euler gains energy wherever a bond has no damping",
                 "choose velocity-verlet, or give every material a loss factor"};
}

std::optional<Problem> findFault(const Network& network, const Environment& environment,
                                 const std::vector<Track>& tracks, const Settings& settings) {
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

std::optional<Problem> findFaultOfReplan(const World& world, const Environment& environment,
                                         const std::vector<Track>& tracks) {
  const std::vector<MovingCollider>& before = world.controls.colliders();
  const std::vector<Collider>& colliders = environment.colliders;
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
  return checkTracks(world.network, environment, tracks);
}

bool sameNetwork(const Network& left, const Network& right) {
  return left.positions == right.positions && left.masses == right.masses && left.radii == right.radii &&
         left.firstBond == right.firstBond && left.bondEnds == right.bondEnds &&
         left.bondClasses == right.bondClasses && left.classes == right.classes &&
         left.thresholds == right.thresholds && left.cells == right.cells &&
         left.materials == right.materials;
}

}  // namespace sim
