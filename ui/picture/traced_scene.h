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

  std::optional<SurfaceHit> nearest(const Vec3f& origin, const Vec3f& direction) const;
  /// Whether anything stands within `distance` along the unit direction.
  bool isBlocked(const Vec3f& origin, const Vec3f& direction, float distance) const;

 private:
  TracedScene() = default;
  SurfaceHit meshHit(std::uint32_t quad, const std::array<float, 4>& weights, const Vec3f& point,
                     const Vec3f& facing) const;

  DrawnMesh mesh_;
  std::vector<Plane> floors_;
  RTCDeviceTy* device_ = nullptr;
  RTCSceneTy* scene_ = nullptr;
};

}  // namespace ui
