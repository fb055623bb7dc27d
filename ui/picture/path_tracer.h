#pragma once

#include "ui/picture/film.h"
#include "ui/picture/sampling.h"
#include "ui/picture/studio.h"
#include "ui/picture/traced_scene.h"

namespace ui {

/// Light along rays: at each surface direct light from the soft boxes, and one way on, chosen at random:
/// scattered by the body, mirrored by its glaze, or through glass. Immutable: any thread may ask.
class PathTracer {
 public:
  PathTracer(const TracedScene& scene, const Studio& studio) : scene_(scene), studio_(studio) {}

  /// The light that arrives at `origin` from the unit `direction`, one sample of it. `time` in [0, 1]:
  /// between opening and closing of the shutter.
  Exposure expose(const Vec3f& origin, const Vec3f& direction, float time, const PixelSampler& sampler) const;

 private:
  struct Shading;
  struct Path;
  struct Lamp;

  Shading shadingAt(const SurfaceHit& hit) const;
  static Lamp lampOf(const SoftBox& box, const Shading& at, const std::array<float, 2>& random);
  static Lamp lampOf(const EnvironmentMap& environment, const Shading& at,
                     const std::array<float, 2>& random);
  Light arriving(const Lamp& lamp, const Shading& at, float time) const;
  Light directLight(const Shading& at, float time, const PixelSampler& sampler) const;
  Light oneLight(const Shading& at, float time, std::array<float, 2> random) const;
  /// The light that comes along a path from where it is.
  Light followed(Path path, const PixelSampler& sampler) const;
  /// Send the path on; false where it ends.
  static bool reflectAtGlass(const SurfaceHit& hit, Path& path);
  static bool refractAtGlass(const SurfaceHit& hit, Path& path);
  void mirror(const Shading& at, const std::array<float, 2>& random, Path& path) const;
  Light shadowed(const SurfaceHit& hit, const Vec3f& direction, float time,
                 const PixelSampler& sampler) const;
  static float mirrorDensity(const Shading& at, const Vec3f& direction, const Vec3f& mirrored);
  float mirrorShare(const Path& path) const;
  Light glossFrom(const EnvironmentMap& around, const Shading& at, const Vec3f& direction, float time,
                  const std::array<float, 2>& random) const;
  Light sky(const Path& path) const;
  float floorShare(const SurfaceHit& hit) const;

  const TracedScene& scene_;
  const Studio& studio_;
};

}  // namespace ui
