#pragma once

#include <cstdint>

namespace sim {

/// The time of a run. Steps of one length are counted and not added up, so that a million of them end where
/// one multiplication says.
struct Clock {
  double segmentStart = 0.0;  ///< s: when the present step length began
  std::uint64_t segmentSteps = 0;
  double step = 0.0;  ///< s: length of the steps of this segment
  /// s: the next step, unless a break cuts it short. For methods that cannot take a step back it is `step`.
  double wanted = 0.0;
  double last = 0.0;  ///< s: length of the step before; zero where forces have leapt since, and at the start

  double now() const { return segmentStart + static_cast<double>(segmentSteps) * step; }
  void setStep(double seconds) {
    if (seconds == step) return;
    segmentStart = now();
    segmentSteps = 0;
    step = seconds;
  }
  void tick() {
    last = step;
    ++segmentSteps;
  }
};

}  // namespace sim
