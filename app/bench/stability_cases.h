#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/dynamics/simulation.h"

namespace app {

/// One strain on the program's stability: a body, what is done to it, and what must hold afterwards.
struct StabilityCase {
  std::string group;  ///< what is varied: "stiffness of an edge, dyn/cm"
  std::string value;  ///< this case's
  std::string method = "velocity-verlet";
  std::function<sim::Result<std::unique_ptr<sim::Simulation>>()> start;
  bool free = false;   ///< nothing acts from outside: momentum must be kept
  double floor = 0.0;  ///< cm: nodes deeper than this below z = 0 went through; 0: there is no floor
  int steps = 2000;
};

/// `small`: one or two of a group, for tests.
std::vector<StabilityCase> stabilityCases(bool small);

struct StabilityResult {
  bool passed = false;
  std::string reason;  ///< empty where it passed
  double maxRise = 0.0;
  double momentumError = 0.0;  ///< change over the sum of m |v|; 0 where something acts from outside
  double deepest = 0.0;        ///< cm below the floor
};
StabilityResult judge(const StabilityCase& stabilityCase);

/// The most unexplained energy a run may gain, relative.
inline constexpr double kMostRise = 0.005;
/// Rounding of 2,000 steps of sums over a few hundred nodes.
inline constexpr double kMostMomentumError = 1e-9;

}  // namespace app
