#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ui/picture/drawn_mesh.h"

struct RTCDeviceTy;
struct RTCSceneTy;

namespace ui {

/// What a ray met.
struct SurfaceHit {
  Vec3f point;
  Vec3f start;   ///< where rays that leave it begin: `point`, lifted onto the smooth surface
  Vec3f facing;  ///< unit geometric normal, towards where the ray came from
  Vec3f normal;  ///< unit shading normal, on the same side
  Vec3f restPoint = Vec3f::Zero();  ///< what bumps stick to
  float distance = 0.0F;            ///< along the ray
  bool entering = true;             ///< met from outside of its body
  const DrawnLook* look = nullptr;  ///< nothing for a floor
};

/// The mesh and the floors, ready for rays. Immutable: any thread may trace.
class TracedScene {
 public:
  /// A floor, which rays meet from above only.
  struct Plane {
    Vec3f normal;
    float offset = 0.0F;  ///< points x of it have normal . x = offset
  };

  /// A Problem when there is not enough memory.
  static sim::Result<std::unique_ptr<TracedScene>> create(DrawnMesh mesh, std::vector<Plane> floors);
  ~TracedScene();
  TracedScene(const TracedScene&) = delete;
  TracedScene& operator=(const TracedScene&) = delete;

  /// `time` in [0, 1]: from when the shutter opens to when it closes.
  std::optional<SurfaceHit> nearest(const Vec3f& origin, const Vec3f& direction, float time) const;
  /// What gets through to `distance` along the unit direction: nothing where anything stands there, but for
  /// glass, which colours it.
  Light transmitted(const Vec3f& origin, const Vec3f& direction, float distance, float time) const;

 private:
  TracedScene() = default;
  bool isBlocked(const Vec3f& origin, const Vec3f& direction, float distance, float time) const;
  SurfaceHit meshHit(std::uint32_t quad, const std::array<float, 4>& weights, const Vec3f& point,
                     const Vec3f& facing, float time) const;

  DrawnMesh mesh_;
  std::vector<Plane> floors_;
  bool hasGlass_ = false;
  RTCDeviceTy* device_ = nullptr;
  RTCSceneTy* scene_ = nullptr;
};

}  // namespace ui
