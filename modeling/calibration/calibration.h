#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "modeling/material/material.h"
#include "sim/base/result.h"

namespace modeling {

/// How the samples fall.
struct CalibrationSettings {
  double speed = 400.0;   ///< cm/s onto an immovable floor: a fall from 80 cm
  double cellSize = 0.6;  ///< cm; thresholds depend on it, so use that of the model
  double tilt = 0.4;      ///< rad: the cylinder lands on its rim
  int trialsPerDecade = 6;
  std::uint64_t seed = 1;
  int threads = 0;
};

enum class TrialVerdict {
  holds,     ///< no piece of size comes off
  breaks,    ///< comes apart into pieces of size, after the impact
  crumbles,  ///< goes to grains where it lands
};
const char* nameOf(TrialVerdict verdict);

/// One sample dropped.
struct Trial {
  double threshold = 0.0;            ///< mean t_ij
  std::optional<double> firstBreak;  ///< s after first contact
  std::size_t fragments = 0;         ///< of more than one node
  std::size_t largeFragments = 0;    ///< of at least a twentieth of the nodes
  double isolatedShare = 0.0;        ///< nodes without bonds, of all
  TrialVerdict verdict = TrialVerdict::holds;
};

struct Calibration {
  std::vector<Trial> trials;  ///< from the highest threshold to the lowest
  std::optional<double>
      threshold;  ///< the middle (geometric) of those that break after the impact; absent: none did
};

/// Finds the threshold of a material as the paper did (section "Breakage tuning"): small hollow
/// cylinders are dropped at a moderate speed with thresholds from that at which nothing breaks down to that
/// at which they crumble at the impact; the wanted one makes them break from the distortion that follows it.
/// `watch` is called after each trial; false stops.
sim::Result<Calibration> calibrate(const Material& material, const CalibrationSettings& settings,
                                   const std::function<bool(const Trial&)>& watch);

}  // namespace modeling
