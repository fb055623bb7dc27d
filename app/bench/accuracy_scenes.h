#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/dynamics/simulation.h"

namespace app {

/// Positions of all nodes at a time (s).
using ClosedForm = std::function<std::vector<sim::Vec3>(double time)>;

/// A motion of which errors are measured. Nothing in it sleeps or flies rigidly: what is compared is the
/// stepping.
struct AccuracyScene {
  std::string name;   ///< of its rows and files: "teapot-hiccup"
  std::string title;  ///< for people
  sim::Network network;
  sim::Environment environment;
  std::vector<sim::Track> tracks;
  sim::Settings settings;     ///< method and step are the benchmark's to choose
  double until = 0.0;         ///< s
  ClosedForm exact;           ///< empty: a finer run is the reference
  bool untilBreak = false;    ///< goes on until the first bond breaks, which must come after `until`
  double dampingRatio = 0.0;  ///< of the stiffest swing; 0: what the material says
  bool brief = false;         ///< of the methods only the default and forward Euler are of interest
  double leastGain = 0.0;     ///< goal: forward Euler's time for 1 % strain error over the default's; 0: none
  double limit = 0.0;         ///< s: the longest stable step of velocity Verlet, untouched by anything
  double forwardLimit = 0.0;  ///< s: that of forward Euler
};

/// `quick`: the small ones only, for tests.
sim::Result<std::vector<AccuracyScene>> accuracyScenes(bool quick);

}  // namespace app
