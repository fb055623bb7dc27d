#include "ui/timeline/track_edits.h"

#include <QCoreApplication>
#include <algorithm>
#include <limits>

namespace ui {
namespace {

using modeling::TargetName;
using sim::TrackTarget;

QString tr(const char* text) {
  return QCoreApplication::translate("Tracks", text);
}

TrackValue neutralValue(const modeling::Scene& scene, const TargetName& target) {
  if (target.target == TrackTarget::gravity) return scene.environment.gravity;
  if (target.target == TrackTarget::colliderRotation) return sim::Vec3(sim::Vec3::Zero());
  if (target.target != TrackTarget::colliderPosition) return 1.0;
  for (const modeling::SceneCollider& collider : scene.environment.colliders) {
    if (collider.name == target.object) return collider.position;
  }
  return sim::Vec3(sim::Vec3::Zero());
}

}  // namespace

QString unitOf(const TargetName& target) {
  switch (target.target) {
    case TrackTarget::gravity:
      return tr("cm/s\u00b2");
    case TrackTarget::colliderPosition:
      return tr("cm");
    case TrackTarget::colliderRotation:
      return tr("\u00b0");
    case TrackTarget::gravityScale:
    case TrackTarget::stiffnessScale:
    case TrackTarget::dampingScale:
      break;
  }
  return QStringLiteral("\u00d7");
}

std::vector<TargetName> targetsOf(const modeling::Scene& scene) {
  std::vector<TargetName> targets = {{TrackTarget::gravityScale, {}}, {TrackTarget::gravity, {}}};
  for (const TrackTarget scale : {TrackTarget::stiffnessScale, TrackTarget::dampingScale}) {
    targets.push_back({scale, {}});
    if (scene.materials.size() < 2) continue;
    for (const modeling::SceneMaterial& material : scene.materials) targets.push_back({scale, material.name});
  }
  for (const modeling::SceneCollider& collider : scene.environment.colliders) {
    targets.push_back({TrackTarget::colliderPosition, collider.name});
    targets.push_back({TrackTarget::colliderRotation, collider.name});
  }
  return targets;
}

sim::Vec3 asVector(const TrackValue& value) {
  if (const auto* scalar = std::get_if<double>(&value)) return {*scalar, 0.0, 0.0};
  return std::get<sim::Vec3>(value);
}

TrackValue asValue(const TargetName& target, const sim::Vec3& vector) {
  if (target.isVector()) return vector;
  return vector.x();
}

std::size_t componentsOf(const TargetName& target) {
  return target.isVector() ? 3 : 1;
}

double leastOf(const TargetName& target) {
  const bool factor =
      target.target == TrackTarget::stiffnessScale || target.target == TrackTarget::dampingScale;
  return factor ? 0.0 : -std::numeric_limits<double>::infinity();
}

sim::Track asTrack(const modeling::SceneTrack& track) {
  sim::Track values;
  values.interpolation = track.interpolation;
  for (const modeling::SceneTrackKey& key : track.keys)
    values.keys.push_back({key.time, asVector(key.value)});
  return values;
}

TrackValue valueAt(const modeling::SceneTrack& track, double time) {
  return asValue(track.target, asTrack(track).valueAt(time));
}

std::size_t addTrack(modeling::Scene& scene, const TargetName& target) {
  modeling::SceneTrack track;
  track.target = target;
  track.keys.push_back({0.0, neutralValue(scene, target)});
  scene.tracks.push_back(std::move(track));
  return scene.tracks.size() - 1;
}

std::size_t addKey(modeling::SceneTrack& track, double time, const TrackValue& value) {
  const auto after =
      std::lower_bound(track.keys.begin(), track.keys.end(), time - kKeyDistance,
                       [](const modeling::SceneTrackKey& key, double moment) { return key.time < moment; });
  const auto place = static_cast<std::size_t>(after - track.keys.begin());
  if (after != track.keys.end() && after->time <= time + kKeyDistance) {
    after->value = value;
  } else {
    track.keys.insert(after, {std::max(time, 0.0), value});
  }
  return place;
}

void moveKey(modeling::SceneTrack& track, std::size_t key, double time) {
  const double least = key > 0 ? track.keys[key - 1].time + kKeyDistance : 0.0;
  double moved = std::max(time, least);
  if (key + 1 < track.keys.size()) moved = std::min(moved, track.keys[key + 1].time - kKeyDistance);
  track.keys[key].time = std::max(moved, 0.0);
}

void removeKey(modeling::Scene& scene, std::size_t track, std::size_t key) {
  std::vector<modeling::SceneTrackKey>& keys = scene.tracks.at(track).keys;
  if (keys.size() > 1) {
    keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(key));
  } else {
    scene.tracks.erase(scene.tracks.begin() + static_cast<std::ptrdiff_t>(track));
  }
}

}  // namespace ui
