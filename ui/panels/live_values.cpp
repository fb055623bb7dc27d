#include "ui/panels/live_values.h"

#include <algorithm>
#include <cmath>

namespace ui {
namespace {

using modeling::Scene;
using modeling::SceneTrack;
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

bool drivesAll(const SceneTrack& track, TrackTarget target) {
  return track.target.target == target && track.target.object.empty();
}

double productOf(const Scene& scene, TrackTarget target, double time, const SceneTrack* except) {
  double product = 1.0;
  for (const SceneTrack& track : scene.tracks) {
    if (drivesAll(track, target) && &track != except) product *= asVector(valueAt(track, time)).x();
  }
  return product;
}

sim::Vec3 gravityAt(const Scene& scene, double time) {
  const SceneTrack* counts = nullptr;
  for (const SceneTrack& track : scene.tracks) {
    if (!drivesAll(track, TrackTarget::gravity)) continue;
    if (counts == nullptr || track.keys.front().time <= time) counts = &track;
  }
  return counts == nullptr ? scene.environment.gravity : asVector(valueAt(*counts, time));
}

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
  values.gravity = gravityAt(scene, time);
  values.gravityScale = productOf(scene, TrackTarget::gravityScale, time, nullptr);
  values.stiffness = productOf(scene, TrackTarget::stiffnessScale, time, nullptr);
  values.damping = productOf(scene, TrackTarget::dampingScale, time, nullptr);
  return values;
}

double performedScale(const Scene& scene, TrackTarget target, double time, double total) {
  const auto performed =
      std::find_if(scene.tracks.rbegin(), scene.tracks.rend(), [&](const SceneTrack& track) {
        return drivesAll(track, target) && track.interpolation == sim::Interpolation::step;
      });
  const SceneTrack* except = performed == scene.tracks.rend() ? nullptr : &*performed;
  const double others = productOf(scene, target, time, except);
  return others == 0.0 ? total : total / others;
}

void setLiveValue(Scene& scene, TrackTarget target, double time, const TrackValue& value) {
  const auto last = std::find_if(scene.tracks.rbegin(), scene.tracks.rend(),
                                 [&](const SceneTrack& track) { return drivesAll(track, target); });
  if (last == scene.tracks.rend()) {
    if (target == TrackTarget::gravity) {
      scene.environment.gravity = asVector(value);
      return;
    }
    SceneTrack track;
    track.target.target = target;
    track.interpolation = sim::Interpolation::step;
    track.keys.push_back({0.0, value});
    scene.tracks.push_back(std::move(track));
    return;
  }
  TrackValue written = value;
  if (!last->target.isVector()) {
    const double others = productOf(scene, target, time, &*last);
    if (others != 0.0) written = asVector(value).x() / others;
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
  const double strength = gravityAt(scene, time).norm();
  if (strength < 1e-6 * kStandardGravity) {
    // Nothing to multiply: it jumps down, and back to nothing.
    const sim::Vec3 down(0.0, 0.0, -kHiccupGravity * kStandardGravity);
    return {{TrackTarget::gravity, {}}, {{0.0, down}, {kHiccupSeconds, gravityAt(scene, end)}}};
  }
  const TrackTarget target = TrackTarget::gravityScale;
  const double jump = performedScale(scene, target, time, kHiccupGravity * kStandardGravity / strength);
  const double back = performedScale(scene, target, end, liveValuesAt(scene, end).gravityScale);
  return {{target, {}}, {{0.0, jump}, {kHiccupSeconds, back}}};
}

LiveKeys sneeze(const Scene& scene, double time) {
  const double end = time + kSneezeSeconds;
  const TrackTarget target = TrackTarget::stiffnessScale;
  const double usual = liveValuesAt(scene, end).stiffness;
  const double soft = performedScale(scene, target, time, kSneezeSoftness * usual);
  const double back = performedScale(scene, target, end, usual);
  return {{target, {}}, {{0.0, soft}, {kSneezeSeconds, back}}};
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
