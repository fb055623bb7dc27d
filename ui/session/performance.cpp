#include "ui/session/performance.h"

#include <algorithm>

#include "modeling/scene/build.h"
#include "modeling/scene/perform.h"

namespace ui {
namespace {

/// A collider keeps the name the run gave it where the scene has no other of that name by now.
void addCollider(const PerformedCollider& performed, modeling::Scene& scene) {
  const auto& colliders = scene.environment.colliders;
  const bool taken = std::ranges::find(colliders, performed.collider.name, &modeling::SceneCollider::name) !=
                     colliders.end();
  if (taken) {
    static_cast<void>(modeling::addPerformer(scene, performed.collider, performed.path));
    return;
  }
  modeling::addAlongPath(scene, performed.collider, performed.path);
}

}  // namespace

void replay(const Performed& performed, modeling::Scene& scene) {
  if (const auto* key = std::get_if<PerformedKey>(&performed)) {
    modeling::performKey(scene, key->target, key->time, key->value);
  } else {
    addCollider(std::get<PerformedCollider>(performed), scene);
  }
}

sim::Status Performance::perform(sim::Simulation& simulation, const modeling::TargetName& target,
                                 const std::vector<modeling::SceneTrackKey>& keys) {
  const double now = modeling::performTime(simulation);
  std::vector<Performed> performed;
  for (const modeling::SceneTrackKey& key : keys)
    performed.push_back(PerformedKey{target, now + key.time, key.value});
  return replan(simulation, performed);
}

sim::Status Performance::performCollider(sim::Simulation& simulation,
                                         const modeling::SceneCollider& prototype,
                                         std::vector<modeling::SceneTrackKey> path) {
  const double now = modeling::performTime(simulation);
  for (modeling::SceneTrackKey& key : path) key.time += now;
  modeling::Scene changed = *scene_;
  static_cast<void>(modeling::addPerformer(changed, prototype, path));
  return replan(simulation, {PerformedCollider{changed.environment.colliders.back(), std::move(path)}});
}

sim::Status Performance::replan(sim::Simulation& simulation, const std::vector<Performed>& performed) {
  auto changed = std::make_shared<modeling::Scene>(*scene_);
  for (const Performed& each : performed) replay(each, *changed);
  modeling::Conditions conditions = modeling::conditionsOf(*changed, simulation.network().materials);
  const sim::Status status =
      simulation.replan(std::move(conditions.environment), std::move(conditions.tracks));
  if (!status) return status;
  scene_ = std::move(changed);
  performed_.insert(performed_.end(), performed.begin(), performed.end());
  return status;
}

}  // namespace ui
