#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "modeling/scene/build.h"
#include "sim/dynamics/simulation.h"
#include "ui/session/footage.h"
#include "ui/session/performance.h"

/// What passes between the window's thread and the one that simulates: values, made by one and only read by
/// the other.
namespace ui {

/// What to simulate, and where to record it.
struct RunPlan {
  modeling::Scene scene;
  std::filesystem::path folder;                       ///< where files that the scene names are looked for
  std::filesystem::path take;                         ///< where it is recorded; replaced
  int threads = 0;                                    ///< 0: all there are
  std::shared_ptr<const modeling::BuiltScene> built;  ///< this very scene, where it was built already
  /// Where it goes on from; absent: from the start.
  struct Continuation {
    std::shared_ptr<Footage> take;
    std::size_t frame = 0;
    bool changed = false;  ///< by the plan's scene; else as the take was run
  };
  std::optional<Continuation> continuation;
};

/// How fast a run goes.
struct Pace {
  /// Simulated seconds a second of the clock that it keeps to where it can; absent: as fast as it can.
  std::optional<double> timeScale;
};

enum class RunPhase {
  idle,       ///< nothing was ever asked for
  preparing,  ///< building the network, finding the stable step
  running,
  paused,
  done,    ///< reached its end
  failed,  ///< RunView::problem says why; what was recorded stays
};

/// A run at one moment; immutable.
struct RunView {
  std::uint64_t run = 0;  ///< which, counted from 1
  RunPhase phase = RunPhase::idle;
  std::shared_ptr<Footage> footage;  ///< null until the network is built
  sim::SnapshotPointer newest;       ///< the present moment, which need not be a frame
  double until = 0.0;                ///< s: when the run ends
  double step = 0.0;                 ///< s
  double realTimeFactor = 0.0;       ///< simulated seconds a second of the clock, lately
  double secondsLeft = 0.0;          ///< s of the clock until the end, at the present speed
  std::uint64_t brokenBonds = 0;
  sim::Work work;
  std::size_t memoryBytes = 0;
  std::uint64_t stateHash = 0;       ///< where the run is done
  std::vector<Performed> performed;  ///< since the start of the run
  std::vector<std::string> notes;    ///< what is allowed but seldom meant
  std::optional<sim::Problem> problem;
};

}  // namespace ui
