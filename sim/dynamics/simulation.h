#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sim/base/result.h"
#include "sim/control/track.h"
#include "sim/methods/step_limit.h"
#include "sim/network/network.h"
#include "sim/state/settings.h"
#include "sim/state/snapshot.h"
#include "sim/state/work.h"

namespace sim {

/// The stepper: owns the moving state and nothing else. Not thread-safe; one thread calls it, inside it uses
/// Settings::threads threads, and its results do not depend on how many.
class Simulation {
 public:
  /// Takes the network over. A Problem when nothing can be done with it: no nodes, a setting out of range, a
  /// track that drives nothing, no stable step for the method, a fixed step longer than any that is stable.
  static Result<std::unique_ptr<Simulation>> create(Network network, Environment environment,
                                                    std::vector<Track> tracks, const Settings& settings);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  /// Steps until time() >= until: ends on the first step at or after it, so that when frames are asked for
  /// does not change the motion. A Problem is a blow-up: it names the node and its material, and the state
  /// stays as it was when found. `afterStep`, if there is one, is called after each step.
  Status advanceTo(double until, const std::function<void()>& afterStep = {});
  /// Exactly one step.
  Status stepOnce();

  /// From the next step on it is as if these had been given to create(), provided they say the same of all
  /// times up to now: what they say of the past is not looked at, so that a run in which they were given
  /// from the start is the same, to the bit. Colliders may be added behind the others. A Problem, and nothing
  /// changed, when a track drives nothing or a collider is gone or of another shape.
  Status replan(Environment environment, std::vector<Track> tracks);

  double time() const;
  double step() const;  ///< s: the step being used now
  StepLimit stepLimit() const;
  /// What is expected of a time.
  struct Pace {
    double time = 0.0;    ///< s
    double speed = 0.0;   ///< of the fastest node, cm/s
    bool deforms = true;  ///< some fragment does
    bool coils = false;   ///< what may touch itself lies upon itself
  };
  /// s: about how long the step will be at each of these, if else things touch as they do now.
  std::vector<double> stepsAt(std::span<const Pace> paces) const;
  std::uint64_t stepCount() const;
  std::uint64_t brokenBondCount() const;

  Snapshot snapshot() const;
  /// Hash of positions, velocities, broken bonds and time: equal for equal runs on any number of threads.
  std::uint64_t stateHash() const;
  /// Largest relative rise of mechanical energy that outside work does not explain, so far.
  double maxRise() const;
  const Work& work() const;
  /// Breaks since the last call, in order of time, then bond.
  std::vector<BreakEvent> drainBreakEvents();

  const Network& network() const;
  /// Bytes of everything this simulation holds.
  std::size_t memoryBytes() const;

  /// Everything a resumed run needs beyond what create() was given; opaque. Restoring into a simulation
  /// created from equal arguments continues bit-identically.
  std::vector<std::byte> checkpoint() const;
  Status restore(std::span<const std::byte> checkpoint);
  /// Before the first step: goes on from where another simulation of an equal network is, by this one's own
  /// settings, environment and tracks. What moves, is bent and broken, the clock and the account of energy
  /// are the other's. What the other conditions change in energy at once is work from outside. The other one
  /// goes on no more. A Problem, and nothing changed, when the networks differ.
  Status takeOver(Simulation& other);

 private:
  struct State;
  explicit Simulation(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace sim
