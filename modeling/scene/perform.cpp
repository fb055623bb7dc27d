#include "modeling/scene/perform.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace modeling {
namespace {

/// Of a step: no method shortens one to so little.
constexpr double kMoment = 0x1p-40;

bool isGravity(const TargetName& target) {
  return target.target == sim::TrackTarget::gravity;
}

/// The track that a key of this target belongs into; null where there is none. A track of gravity only if it
/// is the last, which is the one that counts.
const SceneTrack* performedTrack(const Scene& scene, const TargetName& target) {
  for (auto track = scene.tracks.rbegin(); track != scene.tracks.rend(); ++track) {
    if (track->target != target) continue;
    if (track->interpolation == sim::Interpolation::step) return &*track;
    if (isGravity(target)) return nullptr;
  }
  return nullptr;
}

bool hasTrackOf(const Scene& scene, const TargetName& target) {
  return std::ranges::find(scene.tracks, target, &SceneTrack::target) != scene.tracks.end();
}

/// A track that changes nothing yet.
SceneTrack newTrack(const Scene& scene, const TargetName& target) {
  SceneTrack track;
  track.target = target;
  track.interpolation = sim::Interpolation::step;
  if (!isGravity(target) || !hasTrackOf(scene, target))
    track.keys.push_back({0.0, neutralValue(scene, target)});
  return track;
}

/// Takes the keys from `time` on away. What the first of them said of the time before it stays so.
void cutTrack(const Scene& scene, SceneTrack& track, double time) {
  const bool begun = track.keys.front().time < time;
  const auto firstOfTarget = std::ranges::find(scene.tracks, track.target, &SceneTrack::target);
  const bool decidesBefore = !isGravity(track.target) || &*firstOfTarget == &track;
  const SceneTrackKey first = track.keys.front();
  std::erase_if(track.keys, [&](const SceneTrackKey& key) { return key.time >= time; });
  if (!begun && decidesBefore) track.keys.push_back({0.0, first.value});
}

}  // namespace

double performTime(const sim::Simulation& simulation) {
  const double now = simulation.time();
  return std::max(std::nextafter(now, std::numeric_limits<double>::infinity()),
                  now + kMoment * simulation.step());
}

void performKey(Scene& scene, const TargetName& target, double time, TrackValue value) {
  assert(std::holds_alternative<Vec3>(value) == target.isVector());
  assert(isGravity(target) || !target.isVector());
  assert(time > 0.0);
  const SceneTrack* found = performedTrack(scene, target);
  if (found == nullptr) {
    SceneTrack made = newTrack(scene, target);
    made.keys.push_back({time, std::move(value)});
    scene.tracks.push_back(std::move(made));
    return;
  }
  SceneTrack& track = scene.tracks[static_cast<std::size_t>(found - scene.tracks.data())];
  cutTrack(scene, track, time);
  track.keys.push_back({time, std::move(value)});
}

double performedScale(const Scene& scene, const TargetName& target, double time, double total) {
  const SceneTrack* performed = performedTrack(scene, target);
  const double others =
      performed == nullptr ? scaleAt(scene, target, time) : scaleWithoutAt(scene, *performed, time);
  return others == 0.0 ? total : total / others;
}

std::string addPerformer(Scene& scene, SceneCollider prototype, std::vector<SceneTrackKey> path) {
  assert(path.size() >= 2);
  const auto& colliders = scene.environment.colliders;
  const auto taken = [&](const std::string& name) {
    return std::ranges::find(colliders, name, &SceneCollider::name) != colliders.end();
  };
  const std::string kind = prototype.name + ' ';
  int number = 1;
  while (taken(kind + std::to_string(number))) ++number;
  prototype.name = kind + std::to_string(number);
  prototype.visible = false;
  prototype.active = {path.front().time, path.back().time};
  addAlongPath(scene, std::move(prototype), std::move(path));
  return scene.environment.colliders.back().name;
}

void addAlongPath(Scene& scene, SceneCollider collider, std::vector<SceneTrackKey> path) {
  SceneTrack track;
  track.target = {sim::TrackTarget::colliderPosition, collider.name};
  track.interpolation = sim::Interpolation::linear;
  track.keys = std::move(path);
  scene.tracks.push_back(std::move(track));
  scene.environment.colliders.push_back(std::move(collider));
}

}  // namespace modeling
