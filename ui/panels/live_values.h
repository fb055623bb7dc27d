#pragma once

#include "modeling/scene/tracks.h"

/// What a person changes while it runs, and how it is said in keys.
namespace ui {

/// What drives a whole scene at a moment.
struct LiveValues {
  sim::Vec3 gravity = sim::Vec3::Zero();  ///< cm/s^2, before its scale
  double gravityScale = 1.0;
  double stiffness = 1.0;  ///< of all materials together
  double damping = 1.0;
};

LiveValues liveValuesAt(const modeling::Scene& scene, double time);

/// Without a run: from this time on, or for all times where nothing varies in it, the scene has this value.
void setLiveValue(modeling::Scene& scene, sim::TrackTarget target, double time,
                  const modeling::TrackValue& value);

/// Keys of one target; times count from now.
struct LiveKeys {
  modeling::TargetName target;
  std::vector<modeling::SceneTrackKey> keys;
};
/// Gravity jumps to 5 g and back (paper, Fig. 5).
LiveKeys hiccup(const modeling::Scene& scene, double time);
/// Bonds go soft, sag, and tighten (paper, Fig. 6).
LiveKeys sneeze(const modeling::Scene& scene, double time);

/// An invisible sphere that comes, pushes and goes; times count from now.
struct LiveTouch {
  modeling::SceneCollider collider;
  std::vector<modeling::SceneTrackKey> path;
};
/// How large what is touched is, cm. Only nodes are touched: a sphere must not slip through between them.
struct TouchedSize {
  double everything = 0.0;
  double toNextNode = 0.0;  ///< from the point that is touched to the node nearest to it
};
/// A finger: in at a point of the surface along a direction, and back.
LiveTouch poke(const sim::Vec3& point, const sim::Vec3& direction, const TouchedSize& size);
/// A ball that flies through the point.
LiveTouch knock(const sim::Vec3& point, const sim::Vec3& direction, const TouchedSize& size);

inline constexpr double kStandardGravity = 981.0;  ///< cm/s^2, of the scenes' files

}  // namespace ui
