#pragma once

#include <optional>
#include <vector>

#include "modeling/calibration/calibration.h"
#include "ui/session/background_worker.h"

namespace ui {

/// How far the tuning of a threshold has come; a copy.
struct CalibrationProgress {
  std::vector<modeling::Trial> trials;
  bool ended = false;
  bool cancelled = false;
  std::optional<double> threshold;      ///< what to use; absent: not known (yet)
  std::optional<sim::Problem> problem;  ///< why it ended early
};

/// Drops samples of a material in a thread of its own (BackgroundWorker). A cancelled one ends after the
/// sample that is falling.
class CalibrationRun {
 public:
  CalibrationRun(const modeling::Material& material, const modeling::CalibrationSettings& settings);

  CalibrationProgress progress() const;
  void cancel() { worker_.cancel(); }

 private:
  struct Request {
    modeling::Material material;
    modeling::CalibrationSettings settings;
  };
  struct Found {
    std::vector<modeling::Trial> trials;
    std::optional<double> threshold;
  };
  BackgroundWorker<Request, Found> worker_;
};

}  // namespace ui
