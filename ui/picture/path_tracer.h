#pragma once

#include "ui/picture/film.h"
#include "ui/picture/sampling.h"
#include "ui/picture/studio.h"
#include "ui/picture/traced_scene.h"

namespace ui {

/// Light along rays: direct light from the soft boxes, one traced bounce of diffuse light, one mirror
/// reflection on a glaze. Immutable: any thread may ask.
class PathTracer {
 public:
  PathTracer(const TracedScene& scene, const Studio& studio) : scene_(scene), studio_(studio) {}

  /// The light that arrives at `origin` from the unit `direction`, one sample of it.
  Exposure expose(const Vec3f& origin, const Vec3f& direction, const PixelSampler& sampler) const;

 private:
  struct Shading;

  Shading shadingAt(const SurfaceHit& hit) const;
  Light lightFrom(const SoftBox& box, const Shading& at, const std::array<float, 2>& random) const;
  Light directLight(const Shading& at, const PixelSampler& sampler) const;
  Light indirectLight(const Shading& at, const PixelSampler& sampler) const;
  Light mirrored(const Shading& at, const Vec3f& direction, const PixelSampler& sampler) const;
  Light secondary(const SurfaceHit& hit, const Vec3f& direction, const PixelSampler& sampler,
                  std::uint32_t dimension) const;
  /// Blends what was found on a floor into the backdrop, with distance from the subject.
  Light faded(const SurfaceHit& hit, const Vec3f& direction, const Light& light) const;
  float floorShare(const SurfaceHit& hit) const;

  const TracedScene& scene_;
  const Studio& studio_;
};

}  // namespace ui
