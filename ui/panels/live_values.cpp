#include "ui/panels/live_values.h"

#include <algorithm>
#include <cmath>

#include "modeling/scene/perform.h"

namespace ui {
namespace {

using modeling::Scene;
using modeling::SceneTrack;
using modeling::TrackValue;
using sim::TrackTarget;

/// As the paper has them, in seconds and in times.
constexpr double kHiccupSeconds = 0.1;
constexpr double kHiccupGravity = 5.0;
constexpr double kSneezeSeconds = 0.1;
constexpr double kSneezeSoftness = 0.01;

/// Shares of the size of everything, and cm/s: a finger, and a ball thrown.
constexpr double kFinger = 0.045;
constexpr double kFingerSpeed = 120.0;
constexpr double kBall = 0.09;
constexpr double kBallSpeed = 500.0;
/// Radius over the distance of the nearest node: it is hit, and pushed rather than brushed.
constexpr double kReachOfNode = 1.5;

LiveTouch sphere(const std::string& name, double radius) {
  LiveTouch touch;
  touch.collider.name = name;
  touch.collider.form = modeling::SphereShape{radius};
  touch.collider.visible = false;
  return touch;
}

}  // namespace

LiveValues liveValuesAt(const Scene& scene, double time) {
  LiveValues values;
  values.gravity = modeling::unscaledGravityAt(scene, time);
  values.gravityScale = scaleAt(scene, {TrackTarget::gravityScale, {}}, time);
  values.stiffness = scaleAt(scene, {TrackTarget::stiffnessScale, {}}, time);
  values.damping = scaleAt(scene, {TrackTarget::dampingScale, {}}, time);
  return values;
}

void setLiveValue(Scene& scene, TrackTarget target, double time, const TrackValue& value) {
  const modeling::TargetName all{target, {}};
  const auto last = std::find_if(scene.tracks.rbegin(), scene.tracks.rend(),
                                 [&](const SceneTrack& track) { return track.target == all; });
  if (last == scene.tracks.rend()) {
    if (target == TrackTarget::gravity) {
      scene.environment.gravity = modeling::asVector(value);
      return;
    }
    SceneTrack& added = scene.tracks[addTrack(scene, all)];
    added.interpolation = sim::Interpolation::step;
    added.keys.front().value = value;
    return;
  }
  TrackValue written = value;
  if (!all.isVector()) {
    const double others = scaleWithoutAt(scene, *last, time);
    if (others != 0.0) written = std::get<double>(value) / others;
  }
  if (last->keys.size() == 1) {
    last->keys.front().value = written;
  } else {
    addKey(*last, time, written);
  }
}

/// Back to what it will be by then without this: another hiccup may be under way.
LiveKeys hiccup(const Scene& scene, double time) {
  const double end = time + kHiccupSeconds;
  const double strength = modeling::unscaledGravityAt(scene, time).norm();
  if (strength < 1e-6 * kStandardGravity) {
    // Nothing to multiply: it jumps down, and back to nothing.
    const sim::Vec3 down(0.0, 0.0, -kHiccupGravity * kStandardGravity);
    return {{TrackTarget::gravity, {}},
            {{0.0, down}, {kHiccupSeconds, modeling::unscaledGravityAt(scene, end)}}};
  }
  const modeling::TargetName target{TrackTarget::gravityScale, {}};
  const double jump = performedScale(scene, target, time, kHiccupGravity * kStandardGravity / strength);
  const double back = performedScale(scene, target, end, scaleAt(scene, target, end));
  return {target, {{0.0, jump}, {kHiccupSeconds, back}}};
}

LiveKeys sneeze(const Scene& scene, double time) {
  const double end = time + kSneezeSeconds;
  const modeling::TargetName target{TrackTarget::stiffnessScale, {}};
  const double usual = scaleAt(scene, target, end);
  const double soft = performedScale(scene, target, time, kSneezeSoftness * usual);
  const double back = performedScale(scene, target, end, usual);
  return {target, {{0.0, soft}, {kSneezeSeconds, back}}};
}

LiveTouch poke(const sim::Vec3& point, const sim::Vec3& direction, const TouchedSize& size) {
  const double radius = std::max(kFinger * size.everything, kReachOfNode * size.toNextNode);
  LiveTouch touch = sphere("poke", radius);
  const sim::Vec3 outside = point - 1.1 * radius * direction;
  const sim::Vec3 inside = point + 0.4 * radius * direction;
  const double way = 1.5 * radius / kFingerSpeed;
  touch.path = {{0.0, outside}, {way, inside}, {2.0 * way, inside}, {4.0 * way, outside}};
  return touch;
}

LiveTouch knock(const sim::Vec3& point, const sim::Vec3& direction, const TouchedSize& size) {
  LiveTouch touch = sphere("knock", std::max(kBall * size.everything, kReachOfNode * size.toNextNode));
  const double way = 0.75 * size.everything;
  touch.path = {{0.0, sim::Vec3(point - way * direction)},
                {2.0 * way / kBallSpeed, sim::Vec3(point + way * direction)}};
  return touch;
}

}  // namespace ui
