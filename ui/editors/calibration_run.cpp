#include "ui/editors/calibration_run.h"

namespace ui {

CalibrationRun::CalibrationRun(const modeling::Material& material,
                               const modeling::CalibrationSettings& settings)
    : worker_([](const Request& request, auto& job) -> sim::Status {
        const auto watch = [&job](const modeling::Trial& trial) {
          job.value.trials.push_back(trial);
          job.publish();
          return !job.cancelled();
        };
        const auto found = modeling::calibrate(request.material, request.settings, watch);
        if (!found) return found.problem();
        job.value.threshold = found->threshold;
        return sim::Done{};
      }) {
  worker_.request({material, settings});
}

CalibrationProgress CalibrationRun::progress() const {
  const auto answer = worker_.newest();
  CalibrationProgress progress;
  progress.trials = answer->value.trials;
  progress.threshold = answer->value.threshold;
  progress.ended = answer->ended;
  progress.cancelled = answer->cancelled;
  progress.problem = answer->problem;
  return progress;
}

}  // namespace ui
