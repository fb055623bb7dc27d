#include "ui/picture/path_tracer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/base/random.h"

namespace ui {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// Refractive index of glaze and glass, and the reflectance that it gives straight on.
constexpr float kIndex = 1.5F;
constexpr float kStraightReflectance = 0.04F;

/// Light that has been scattered is cut here, so that no lucky path leaves a bright dot.
constexpr float kBrightestIndirect = 3.0F;

/// After so many surfaces that scatter, what comes from more of them is taken for a share of the dome's
/// light.
constexpr int kMostScatterings = 3;
constexpr float kAmbient = 0.28F;
/// Surfaces of any kind: glass has two a pane.
constexpr int kMostSurfaces = 16;

/// Dimensions of a sample, so that each decision is spread on its own. 0 to 2 are the camera's. Each surface
/// of a path has kSurfaceDimensions from its own first on.
enum Dimension : std::uint32_t { kKey = 3, kFill, kBounce, kMirror, kPaths };
enum SurfaceDimension : std::uint32_t { kChoice, kDirection, kLight, kSurfaceDimensions };

float fresnel(float cosine) {
  const float m = std::clamp(1.0F - cosine, 0.0F, 1.0F);
  return kStraightReflectance + (1.0F - kStraightReflectance) * m * m * m * m * m;
}

/// Smooth noise in [-1, 1]: random values at whole coordinates, blended.
float noise(const Vec3f& at) {
  const Eigen::Array3f cell = at.array().floor();
  const Eigen::Array3f part = at.array() - cell;
  const Eigen::Array3f blend = part * part * (3.0F - 2.0F * part);
  float sum = 0.0F;
  for (unsigned corner = 0; corner < 8; ++corner) {
    float weight = 1.0F;
    std::uint64_t key = 0;
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned step = corner >> axis & 1U;
      weight *= step != 0 ? blend[axis] : 1.0F - blend[axis];
      key = key << 21U |
            ((static_cast<std::uint64_t>(static_cast<std::int64_t>(cell[axis])) + step) & 0x1fffffU);
    }
    sum += weight * (static_cast<float>(sim::mixBits(key) >> 40U) * 0x1.0p-23F - 1.0F);
  }
  return sum;
}

/// The slope of bumps of two sizes, as on broken ceramic: grains of a few millimetres with finer ones on
/// them.
Vec3f grainyNormal(const SurfaceHit& hit) {
  constexpr float kCoarse = 5.0F;  ///< bumps per cm
  constexpr float kFine = 17.0F;
  constexpr float kSteepness = 0.22F;
  const Vec3f shift(31.7F, 11.3F, 57.9F);
  Vec3f slope;
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3f at = hit.restPoint + static_cast<float>(axis) * shift;
    slope[axis] = noise(kCoarse * at) + 0.6F * noise(kFine * at);
  }
  const Vec3f bumped = (hit.normal + kSteepness * slope).normalized();
  return bumped.dot(hit.facing) > 0.0F ? bumped : hit.normal;
}

/// What Fresnel's and Snell's laws say of a ray that meets glass.
struct Refraction {
  float ratio;       ///< of the indices, before to behind
  float in;          ///< cosine of the angle to the normal, before
  float out = 0.0F;  ///< and behind; 0 where all is reflected
  float reflectance = 1.0F;
};

Refraction refraction(const SurfaceHit& hit, const Vec3f& direction) {
  Refraction at{hit.entering ? 1.0F / kIndex : kIndex, std::clamp(-direction.dot(hit.normal), 0.0F, 1.0F)};
  const float outSquared = 1.0F - at.ratio * at.ratio * (1.0F - at.in * at.in);
  if (outSquared <= 0.0F) return at;
  at.out = std::sqrt(outSquared);
  const float across = (at.ratio * at.in - at.out) / (at.ratio * at.in + at.out);
  const float along = (at.in - at.ratio * at.out) / (at.in + at.ratio * at.out);
  at.reflectance = 0.5F * (across * across + along * along);
  return at;
}

}  // namespace

struct PathTracer::Shading {
  Vec3f point;
  Vec3f facing;
  Vec3f normal;
  Light colour;
  float glaze = 0.0F;
  float roughness = 0.0F;
};

struct PathTracer::Path {
  /// Where a path sees the room: what a camera sees, perhaps through glass, is the backdrop; mirrors show the
  /// soft boxes; what was scattered has asked the soft boxes already.
  enum class Sees { backdrop, room, dome };

  Vec3f origin;
  Vec3f direction;
  float time = 0.0F;
  Light share = Light::Ones();
  Sees sees = Sees::dome;
  std::uint32_t dimension = kPaths;
};

PathTracer::Shading PathTracer::shadingAt(const SurfaceHit& hit) const {
  Shading at{hit.start, hit.facing, hit.normal,
             Light(Studio::kFloorAlbedo[0], Studio::kFloorAlbedo[1], Studio::kFloorAlbedo[2])};
  if (hit.look == nullptr) return at;
  if (hit.look->grainy) at.normal = grainyNormal(hit);
  at.colour = hit.look->colour;
  at.glaze = hit.look->glaze;
  at.roughness = hit.look->roughness;
  return at;
}

Light PathTracer::lightFrom(const SoftBox& box, const Shading& at, float time,
                            const std::array<float, 2>& random) const {
  const Vec3f offset = box.pointAt(random) - at.point;
  const float distance = offset.norm();
  const Vec3f direction = offset / distance;
  const float falling = at.normal.dot(direction);
  const float leaving = -box.front.dot(direction);
  if (falling <= 0.0F || leaving <= 0.0F) return Light::Zero();
  const Light through = scene_.transmitted(at.point, direction, distance, time);
  return through * box.radianceAt(random) * (falling * leaving * box.area / (kPi * distance * distance));
}

/// One of the two lights, chosen by the first number, which is then stretched to serve again.
Light PathTracer::oneLight(const Shading& at, float time, std::array<float, 2> random) const {
  constexpr float kKeyShare = 0.7F;
  const bool key = random[0] < kKeyShare;
  random[0] = key ? random[0] / kKeyShare : (random[0] - kKeyShare) / (1.0F - kKeyShare);
  return lightFrom(studio_.lights[key ? 0 : 1], at, time, random) / (key ? kKeyShare : 1.0F - kKeyShare);
}

Light PathTracer::sky(const Path& path) const {
  switch (path.sees) {
    case Path::Sees::backdrop:
      return studio_.backdrop(path.direction);
    case Path::Sees::room:
      return studio_.reflected(path.origin, path.direction);
    case Path::Sees::dome:
      break;
  }
  return studio_.dome(path.direction);
}

void PathTracer::mirror(const Shading& at, const std::array<float, 2>& random, Path& path) const {
  const Eigen::Matrix3f frame = frameAround(at.normal);
  const Vec3f view = frame.transpose() * -path.direction;
  const Vec3f half = frame * visibleGgxNormal(view, at.roughness, random);
  Vec3f mirrored = path.direction - 2.0F * path.direction.dot(half) * half;
  // Near the outline a shading normal can send the ray under the surface: let it graze instead.
  if (const float depth = mirrored.dot(at.facing); depth <= 0.0F)
    mirrored = (mirrored + (0.01F - depth) * at.facing).normalized();
  path.share *= fresnel(std::abs(path.direction.dot(half)));
  path.origin = at.point;
  path.direction = mirrored;
  path.sees = Path::Sees::room;
}

bool PathTracer::reflectAtGlass(const SurfaceHit& hit, Path& path) {
  if (!hit.entering) path.share *= glassColour(*hit.look, hit.distance);
  path.origin = hit.point;
  path.direction = (path.direction - 2.0F * path.direction.dot(hit.normal) * hit.normal).normalized();
  if (path.sees == Path::Sees::backdrop) path.sees = Path::Sees::room;
  return path.direction.dot(hit.facing) > 0.0F;
}

bool PathTracer::refractAtGlass(const SurfaceHit& hit, Path& path) {
  if (!hit.entering) path.share *= glassColour(*hit.look, hit.distance);
  const Refraction at = refraction(hit, path.direction);
  path.origin = hit.point;
  path.direction = (at.ratio * path.direction + (at.ratio * at.in - at.out) * hit.normal).normalized();
  return path.direction.dot(hit.facing) < 0.0F;
}

Light PathTracer::followed(Path path, const PixelSampler& sampler) const {
  Light light = Light::Zero();
  int scatterings = path.sees == Path::Sees::dome ? 1 : 0;
  for (int surface = 0; surface < kMostSurfaces; ++surface, path.dimension += kSurfaceDimensions) {
    const auto hit = scene_.nearest(path.origin, path.direction, path.time);
    if (!hit) return light + path.share * sky(path);
    float choice = sampler.pair(path.dimension + kChoice)[0];
    if (hit->look == nullptr) {
      // A floor fades into the backdrop.
      const float there = floorShare(*hit);
      if (choice >= there) return light + path.share * studio_.backdrop(path.direction);
    } else if (hit->look->glass) {
      const bool reflects = choice < refraction(*hit, path.direction).reflectance;
      if (!(reflects ? reflectAtGlass(*hit, path) : refractAtGlass(*hit, path))) return light;
      continue;
    }
    const Shading at = shadingAt(*hit);
    const float mirrored = at.glaze * fresnel(std::abs(at.normal.dot(path.direction)));
    // A weak reflection that is seldom chosen would be noise: after scattering it goes with the rest.
    if (scatterings == 0 && choice < mirrored) {
      const Vec3f before = path.direction;
      const Light share = path.share;
      mirror(at, sampler.pair(path.dimension + kDirection), path);
      path.share = share * fresnel(std::abs(at.normal.dot(before))) * at.glaze / mirrored;
      continue;
    }
    path.share *= at.colour;
    light += path.share * oneLight(at, path.time, sampler.pair(path.dimension + kLight));
    if (++scatterings > kMostScatterings) return light + kAmbient * path.share;
    path.origin = at.point;
    path.direction = frameAround(at.normal) * cosineHemisphere(sampler.pair(path.dimension + kDirection));
    path.sees = Path::Sees::dome;
    if (at.facing.dot(path.direction) <= 0.0F) return light;
  }
  return light;
}

float PathTracer::floorShare(const SurfaceHit& hit) const {
  const float reach = hit.point.norm();
  return 1.0F - smoothStep(studio_.fadeFrom, studio_.fadeTo, reach);
}

Exposure PathTracer::expose(const Vec3f& origin, const Vec3f& direction, float time,
                            const PixelSampler& sampler) const {
  Exposure exposure;
  const auto hit = scene_.nearest(origin, direction, time);
  if (!hit || (hit->look == nullptr && floorShare(*hit) <= 0.0F)) {
    exposure.rest = studio_.backdrop(direction);
    return exposure;
  }
  if (hit->look != nullptr && hit->look->glass) {
    // Both ways: highlights are too bright to be left to chance.
    const float reflectance = refraction(*hit, direction).reflectance;
    Path path{origin, direction, time, Light::Constant(1.0F - reflectance), Path::Sees::backdrop};
    if (refractAtGlass(*hit, path)) exposure.rest = followed(path, sampler);
    path = {origin,
            direction,
            time,
            Light::Constant(reflectance),
            Path::Sees::backdrop,
            kPaths + kMostSurfaces * kSurfaceDimensions};
    if (reflectAtGlass(*hit, path)) exposure.rest += followed(path, sampler);
    exposure.point = hit->point;
    exposure.normal = hit->normal;
    return exposure;
  }
  const Shading at = shadingAt(*hit);
  const float share = hit->look == nullptr ? floorShare(*hit) : 1.0F;
  const float through = 1.0F - at.glaze * fresnel(std::abs(at.normal.dot(direction)));
  exposure.colour = share * through * at.colour;
  const Vec3f bounce = frameAround(at.normal) * cosineHemisphere(sampler.pair(kBounce));
  if (at.facing.dot(bounce) > 0.0F)
    exposure.indirect = followed({at.point, bounce, time}, sampler).min(kBrightestIndirect);
  exposure.rest = exposure.colour * (lightFrom(studio_.lights[0], at, time, sampler.pair(kKey)) +
                                     lightFrom(studio_.lights[1], at, time, sampler.pair(kFill)));
  if (at.glaze > 0.0F) {
    Path path{origin, direction, time};
    mirror(at, sampler.pair(kMirror), path);
    // Its own numbers, apart from the scattered path's.
    path.dimension += kMostSurfaces * kSurfaceDimensions;
    exposure.rest += at.glaze * followed(path, sampler);
  }
  if (share < 1.0F) exposure.rest += (1.0F - share) * studio_.backdrop(direction);
  exposure.point = hit->point;
  exposure.normal = at.normal;
  return exposure;
}

}  // namespace ui
