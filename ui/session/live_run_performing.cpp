#include <algorithm>

#include "modeling/scene/perform.h"
#include "ui/session/live_run.h"

namespace ui {
namespace {

/// A collider keeps the name the run gave it where the scene has no other of
/// that name by now.
void addCollider(const PerformedCollider& performed, modeling::Scene& scene) {
  auto& colliders = scene.environment.colliders;
  const bool taken = std::ranges::find(colliders, performed.collider.name, &modeling::SceneCollider::name) !=
                     colliders.end();
  if (taken) {
    static_cast<void>(modeling::addPerformer(scene, performed.collider, performed.path));
    return;
  }
  modeling::SceneTrack track;
  track.target = {sim::TrackTarget::colliderPosition, performed.collider.name};
  track.interpolation = sim::Interpolation::linear;
  track.keys = performed.path;
  scene.tracks.push_back(std::move(track));
  colliders.push_back(performed.collider);
}

}  // namespace

void replay(const Performed& performed, modeling::Scene& scene) {
  if (const auto* key = std::get_if<PerformedKey>(&performed)) {
    modeling::performKey(scene, key->target, key->time, key->value);
  } else {
    addCollider(std::get<PerformedCollider>(performed), scene);
  }
}

void LiveRun::perform(const modeling::TargetName& target, const std::vector<modeling::SceneTrackKey>& keys) {
  if (phase_ != RunPhase::running && phase_ != RunPhase::paused) return;
  const double now = modeling::performTime(*simulation_);
  std::vector<Performed> performed;
  for (const modeling::SceneTrackKey& key : keys)
    performed.push_back(PerformedKey{target, now + key.time, key.value});
  replan(std::move(performed));
}

void LiveRun::performCollider(const modeling::SceneCollider& prototype,
                              std::vector<modeling::SceneTrackKey> path) {
  if (path.size() < 2 || (phase_ != RunPhase::running && phase_ != RunPhase::paused)) return;
  const double now = modeling::performTime(*simulation_);
  for (modeling::SceneTrackKey& key : path) key.time += now;
  modeling::Scene changed = scene_;
  static_cast<void>(modeling::addPerformer(changed, prototype, path));
  replan({PerformedCollider{changed.environment.colliders.back(), std::move(path)}});
}

/// What cannot be done changes nothing, neither the run nor the scene.
void LiveRun::replan(std::vector<Performed> performed) {
  modeling::Scene changed = scene_;
  for (const Performed& each : performed) replay(each, changed);
  modeling::Conditions conditions = modeling::conditionsOf(changed, simulation_->network().materials);
  const sim::Status status =
      simulation_->replan(std::move(conditions.environment), std::move(conditions.tracks));
  changed_ = true;
  if (!status) {
    notes_.push_back(status.problem().line());
    return;
  }
  scene_ = std::move(changed);
  sceneWritten_ = false;
  footage_->setScene(scene_);
  performed_.insert(performed_.end(), performed.begin(), performed.end());
}

}  // namespace ui
