#include "modeling/scene/tracks.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numbers>
#include <utility>

#include "modeling/scene/build.h"
#include "modeling/text/dimension.h"
#include "sim/control/driven.h"

namespace modeling {
namespace {

using sim::TrackTarget;

/// Of gravity, stiffness and damping.
constexpr double kMostScale = 1e6;

/// The track's values as they are written, driving nothing.
sim::Track writtenValues(const SceneTrack& track) {
  sim::Track values;
  values.target = track.target.target;
  values.interpolation = track.interpolation;
  for (const SceneTrackKey& key : track.keys) values.keys.push_back({key.time, asVector(key.value)});
  return values;
}

/// In the units of a simulation, driving all objects.
sim::Track simulationTrack(const SceneTrack& written) {
  sim::Track track = writtenValues(written);
  if (unitOf(written.target) == TrackUnit::degrees) {
    for (sim::Track::Key& key : track.keys) key.value = Vec3(key.value * (std::numbers::pi / 180.0));
  }
  return track;
}

void addTracksOf(const SceneTrack& written, const Scene& scene, const std::vector<std::string>& materials,
                 std::vector<sim::Track>& tracks) {
  const sim::Track track = simulationTrack(written);
  const std::string& object = written.target.object;
  const auto add = [&](std::size_t index) {
    tracks.push_back(track);
    tracks.back().object = static_cast<std::uint32_t>(index);
  };
  if (object.empty()) {
    tracks.push_back(track);
  } else if (sim::drivesCollider(track.target)) {
    const auto& colliders = scene.environment.colliders;
    const auto found = std::ranges::find(colliders, object, &SceneCollider::name);
    add(static_cast<std::size_t>(found - colliders.begin()));
  } else {
    for (std::size_t m = 0; m < materials.size(); ++m) {
      if (materials[m] == object) add(m);
    }
  }
}

std::vector<std::string> materialsOf(const Scene& scene) {
  std::vector<std::string> names;
  for (const SceneMaterial& material : scene.materials) names.push_back(material.name);
  return names;
}

/// For what a simulation has of the scene's materials one each.
std::vector<sim::Track> simulationTracks(const Scene& scene) {
  return simulationTracks(scene, materialsOf(scene));
}

std::uint32_t objectOf(const Scene& scene, const TargetName& target) {
  if (target.object.empty()) return sim::kNone;
  const auto found = std::ranges::find(scene.materials, target.object, &SceneMaterial::name);
  return static_cast<std::uint32_t>(found - scene.materials.begin());
}

}  // namespace

TrackUnit unitOf(const TargetName& target) {
  switch (target.target) {
    case TrackTarget::gravity:
      return TrackUnit::acceleration;
    case TrackTarget::colliderPosition:
      return TrackUnit::length;
    case TrackTarget::colliderRotation:
      return TrackUnit::degrees;
    case TrackTarget::gravityScale:
    case TrackTarget::stiffnessScale:
    case TrackTarget::dampingScale:
      return TrackUnit::factor;
  }
  assert(false);
  return TrackUnit::factor;
}

std::size_t componentsOf(const TargetName& target) {
  return target.isVector() ? 3 : 1;
}

double leastOf(const TargetName& target) {
  return sim::scalesMaterial(target.target) ? 0.0 : -mostOf(target);
}

double mostOf(const TargetName& target) {
  switch (unitOf(target)) {
    case TrackUnit::acceleration:
      return reachOf(Dimension::acceleration);
    case TrackUnit::length:
      return reachOf(Dimension::length);
    case TrackUnit::degrees:
      return reachOf(Dimension::degrees);
    case TrackUnit::factor:
      return kMostScale;
  }
  return kMostScale;
}

Vec3 asVector(const TrackValue& value) {
  if (const auto* scalar = std::get_if<double>(&value)) return {*scalar, 0.0, 0.0};
  return std::get<Vec3>(value);
}

TrackValue asValue(const TargetName& target, const Vec3& vector) {
  if (target.isVector()) return vector;
  return vector.x();
}

std::vector<TargetName> targetsOf(const Scene& scene) {
  const auto isDriven = [&](const TargetName& target) {
    return std::ranges::find(scene.tracks, target, &SceneTrack::target) != scene.tracks.end();
  };
  std::vector<TargetName> targets = {{TrackTarget::gravityScale, {}}, {TrackTarget::gravity, {}}};
  for (const TrackTarget scale : {TrackTarget::stiffnessScale, TrackTarget::dampingScale}) {
    targets.push_back({scale, {}});
    for (const SceneMaterial& material : scene.materials) {
      const TargetName single{scale, material.name};
      if (scene.materials.size() > 1 || isDriven(single)) targets.push_back(single);
    }
  }
  for (const SceneCollider& collider : scene.environment.colliders) {
    targets.push_back({TrackTarget::colliderPosition, collider.name});
    targets.push_back({TrackTarget::colliderRotation, collider.name});
  }
  return targets;
}

TrackValue neutralValue(const Scene& scene, const TargetName& target) {
  switch (unitOf(target)) {
    case TrackUnit::factor:
      return 1.0;
    case TrackUnit::acceleration:
      return scene.environment.gravity;
    case TrackUnit::degrees:
      return Vec3(Vec3::Zero());
    case TrackUnit::length:
      break;
  }
  const auto& colliders = scene.environment.colliders;
  const auto found = std::ranges::find(colliders, target.object, &SceneCollider::name);
  return found == colliders.end() ? Vec3(Vec3::Zero()) : found->position;
}

std::vector<sim::Track> simulationTracks(const Scene& scene, const std::vector<std::string>& materials) {
  std::vector<sim::Track> tracks;
  for (const SceneTrack& track : scene.tracks) addTracksOf(track, scene, materials, tracks);
  return tracks;
}

TrackValue valueAt(const SceneTrack& track, double time) {
  return asValue(track.target, writtenValues(track).valueAt(time));
}

Vec3 gravityAt(const Scene& scene, double time) {
  return sim::gravityAt(simulationTracks(scene), scene.environment.gravity, time);
}

Vec3 unscaledGravityAt(const Scene& scene, double time) {
  return sim::unscaledGravityAt(simulationTracks(scene), scene.environment.gravity, time);
}

double scaleAt(const Scene& scene, const TargetName& target, double time) {
  assert(!target.isVector());
  return sim::scaleAt(simulationTracks(scene), target.target, objectOf(scene, target), time);
}

double scaleWithoutAt(const Scene& scene, const SceneTrack& without, double time) {
  assert(!without.target.isVector());
  const std::vector<std::string> materials = materialsOf(scene);
  std::vector<sim::Track> tracks;
  for (const SceneTrack& track : scene.tracks) {
    if (&track != &without) addTracksOf(track, scene, materials, tracks);
  }
  return sim::scaleAt(tracks, without.target.target, objectOf(scene, without.target), time);
}

std::vector<sim::Collider> collidersAt(const Scene& scene, double time) {
  const std::vector<sim::Track> tracks = simulationTracks(scene);
  std::vector<sim::Collider> colliders;
  for (std::uint32_t c = 0; c < scene.environment.colliders.size(); ++c) {
    sim::DrivenCollider driven = sim::colliderAt(colliderOf(scene.environment.colliders[c]), c, tracks, time);
    if (driven.at.active) colliders.push_back(std::move(driven.at.shape));
  }
  return colliders;
}

std::size_t addTrack(Scene& scene, const TargetName& target) {
  SceneTrack track;
  track.target = target;
  track.keys.push_back({0.0, neutralValue(scene, target)});
  scene.tracks.push_back(std::move(track));
  return scene.tracks.size() - 1;
}

void setTarget(Scene& scene, std::size_t track, const TargetName& target) {
  SceneTrack& changed = scene.tracks.at(track);
  if (target.isVector() != changed.target.isVector()) {
    for (SceneTrackKey& key : changed.keys) key.value = neutralValue(scene, target);
  }
  changed.target = target;
}

std::size_t addKey(SceneTrack& track, double time, const TrackValue& value) {
  time = std::max(time, 0.0);
  const auto after =
      std::lower_bound(track.keys.begin(), track.keys.end(), time - kKeyDistance,
                       [](const SceneTrackKey& key, double moment) { return key.time < moment; });
  const auto index = static_cast<std::size_t>(after - track.keys.begin());
  if (after != track.keys.end() && after->time <= time + kKeyDistance) {
    after->value = value;
  } else {
    track.keys.insert(after, {time, value});
  }
  return index;
}

void moveKey(SceneTrack& track, std::size_t key, double time) {
  double least = 0.0;
  double most = std::numeric_limits<double>::infinity();
  if (key > 0) least = track.keys[key - 1].time + kKeyDistance;
  if (key + 1 < track.keys.size()) most = track.keys[key + 1].time - kKeyDistance;
  // What was performed may lie closer together, and leaves no room to move in.
  if (least <= most) track.keys[key].time = std::clamp(time, least, most);
}

void removeKey(Scene& scene, std::size_t track, std::size_t key) {
  std::vector<SceneTrackKey>& keys = scene.tracks.at(track).keys;
  if (keys.size() > 1) {
    keys.erase(keys.begin() + static_cast<std::ptrdiff_t>(key));
  } else {
    scene.tracks.erase(scene.tracks.begin() + static_cast<std::ptrdiff_t>(track));
  }
}

}  // namespace modeling
