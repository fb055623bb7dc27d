#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "modeling/calibration/calibration.h"

namespace ui {

/// How far the tuning of a threshold has come; a copy.
struct CalibrationProgress {
  std::vector<modeling::Trial> trials;
  bool ended = false;
  bool cancelled = false;
  std::optional<double> threshold;      ///< what to use; absent: not known (yet)
  std::optional<sim::Problem> problem;  ///< why it ended early
};

/// Drops samples of a material in a thread of its own. A cancelled one ends after the sample that is falling;
/// nobody waits for it.
class CalibrationRun {
 public:
  CalibrationRun(const modeling::Material& material, const modeling::CalibrationSettings& settings);
  ~CalibrationRun();
  CalibrationRun(const CalibrationRun&) = delete;
  CalibrationRun& operator=(const CalibrationRun&) = delete;

  CalibrationProgress progress() const;
  void cancel();

 private:
  struct State;
  std::shared_ptr<State> state_;  ///< shared with the thread, which may outlive this
};

}  // namespace ui
