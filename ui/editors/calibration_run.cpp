#include "ui/editors/calibration_run.h"

#include <exception>
#include <mutex>
#include <thread>

#include "ui/session/background.h"

namespace ui {

struct CalibrationRun::State {
  mutable std::mutex mutex;  ///< of all below
  CalibrationProgress progress;
  bool cancelling = false;

  bool watch(const modeling::Trial& trial) {
    const std::lock_guard lock(mutex);
    progress.trials.push_back(trial);
    return !cancelling;
  }
  void end(const sim::Result<modeling::Calibration>& result) {
    const std::lock_guard lock(mutex);
    if (result) {
      progress.threshold = result->threshold;
    } else {
      progress.problem = result.problem();
    }
    progress.cancelled = cancelling;
    progress.ended = true;
  }
};

namespace {

sim::Result<modeling::Calibration> calibrated(const modeling::Material& material,
                                              const modeling::CalibrationSettings& settings,
                                              const std::function<bool(const modeling::Trial&)>& watch) {
  try {
    return modeling::calibrate(material, settings, watch);
  } catch (const std::bad_alloc&) {
    return sim::Problem{"", "there is not enough memory for the samples", "use larger cells"};
  } catch (const std::exception& exception) {
    return sim::Problem{"", std::string("the samples could not be dropped: ") + exception.what(), ""};
  }
}

}  // namespace

CalibrationRun::CalibrationRun(const modeling::Material& material,
                               const modeling::CalibrationSettings& settings)
    : state_(std::make_shared<State>()) {
  std::thread([state = state_, material, settings] {
    giveWayToTheWindow();
    state->end(
        calibrated(material, settings, [&](const modeling::Trial& trial) { return state->watch(trial); }));
  }).detach();
}

CalibrationRun::~CalibrationRun() {
  cancel();
}

void CalibrationRun::cancel() {
  const std::lock_guard lock(state_->mutex);
  state_->cancelling = true;
}

CalibrationProgress CalibrationRun::progress() const {
  const std::lock_guard lock(state_->mutex);
  return state_->progress;
}

}  // namespace ui
