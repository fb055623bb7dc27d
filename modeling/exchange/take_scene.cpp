#include "modeling/exchange/take_scene.h"

#include <algorithm>
#include <numbers>
#include <utility>
#include <variant>

#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "sim/control/track.h"

namespace modeling {

namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

sim::Vec3 vectorAt(const SceneTrack& track, double time) {
  sim::Track values;
  values.interpolation = track.interpolation;
  for (const SceneTrackKey& key : track.keys) values.keys.push_back({key.time, std::get<Vec3>(key.value)});
  return values.valueAt(time);
}

}  // namespace

sim::Result<Scene> sceneOf(const sim::TakeReader& take, const std::vector<std::string>& settings) {
  if (take.header().scene.empty()) return Scene{};
  auto file = parseScene(take.header().scene, "the take's scene", settings);
  if (!file) return file.problem();
  return std::move(file->scene);
}

std::vector<Look> looksOf(const Scene& scene, const sim::Network& network) {
  std::vector<Look> looks;
  for (const sim::Material& material : network.materials) {
    const auto named = [&](const SceneMaterial& other) { return other.name == material.name; };
    const auto found = std::find_if(scene.materials.begin(), scene.materials.end(), named);
    looks.push_back(found == scene.materials.end() ? Look{} : found->values.look);
  }
  return looks;
}

std::vector<sim::Collider> collidersAt(const Scene& scene, double time) {
  std::vector<sim::Collider> colliders;
  for (const SceneCollider& made : scene.environment.colliders) {
    sim::Collider collider = colliderOf(made);
    if (!collider.activeAt(time)) continue;
    for (const SceneTrack& track : scene.tracks) {
      if (track.target.object != made.name) continue;
      if (track.target.target == sim::TrackTarget::colliderPosition)
        collider.position = vectorAt(track, time);
      if (track.target.target == sim::TrackTarget::colliderRotation) {
        const Vec3 turn = kRadiansPerDegree * vectorAt(track, time);
        collider.rotation =
            Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()) * made.rotation.quaternion();
      }
    }
    colliders.push_back(std::move(collider));
  }
  return colliders;
}

}  // namespace modeling
