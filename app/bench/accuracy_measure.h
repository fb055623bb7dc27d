#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/bench/accuracy_scenes.h"

namespace app {

/// What is compared: the state at equal parts of the scene's time, and what it took to get there.
struct Course {
  std::string status = "done";                    ///< else why there is nothing to compare
  double step = 0.0;                              ///< s
  double cpuSeconds = 0.0;                        ///< of the stepping alone, this thread
  std::vector<std::vector<sim::Vec3>> positions;  ///< at each moment
  double energyError = 0.0;  ///< largest residual of the ledger over the most energy in motion and bonds
  std::optional<sim::BreakEvent> firstBreak;
  bool done() const { return status == "done"; }
};

/// How the state is stepped; a step of nothing is the automatic one.
struct Stepping {
  sim::Method method = sim::Method::velocityVerlet;
  std::optional<double> step;  ///< s: at most; shortened so that a whole number of steps ends at each moment
};

/// Moments at which states are compared.
inline constexpr int kMoments = 8;

/// Steps through the scene once. Gives up ("too slow") where it would take longer than `mostSeconds`.
Course follow(const AccuracyScene& scene, const Stepping& stepping, double mostSeconds);
/// The scene's closed form as a course.
Course exactCourse(const AccuracyScene& scene);

/// Of one course against a better one, over all moments and all nodes or bonds (root mean square), relative
/// to the displacement since the start and to the strain.
struct Errors {
  double position = 0.0;
  double strain = 0.0;
  std::optional<double> breakTime;   ///< relative to the time of the better one's first break
  std::optional<double> breakPlace;  ///< cm between the middles of the bonds that broke first
};
Errors errorsOf(const AccuracyScene& scene, const Course& course, const Course& better);

}  // namespace app
