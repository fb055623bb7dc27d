#include "ui/session/live_run.h"

namespace ui {

void replay(const Performed&, modeling::Scene&) {}

void LiveRun::perform(const modeling::TargetName&, const std::vector<modeling::SceneTrackKey>&) {}

void LiveRun::performCollider(const modeling::SceneCollider&, std::vector<modeling::SceneTrackKey>) {}

}  // namespace ui
