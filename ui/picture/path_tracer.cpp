#include "ui/picture/path_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "ui/picture/ground_pattern.h"

namespace ui {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// Refractive index of glaze and glass, and the reflectance that it gives straight on.
constexpr float kIndex = 1.5F;
constexpr float kStraightReflectance = 0.04F;

/// Light that has been scattered, or mirrored in a mirror image, is cut here, so that no lucky path leaves a
/// bright dot.
constexpr float kBrightestIndirect = 3.0F;

/// GGX alpha from which on a mirror image shows no highlights of its own.
constexpr float kBlurring = 0.1F;

/// After so many surfaces that scatter, what comes from more of them is taken for a share of the dome's
/// light (Studio::ambient).
constexpr int kMostScatterings = 3;
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
  float density = 0.0F;  ///< per steradian, of a mirrored direction for which the environment was asked, too
  bool blurred = false;  ///< mirrored by a rough surface
  bool chosen = false;   ///< mirrored by chance, seldom
};

PathTracer::Shading PathTracer::shadingAt(const SurfaceHit& hit) const {
  Shading at{hit.start, hit.facing, hit.normal, Light::Zero()};
  if (hit.look == nullptr) {
    const Eigen::Matrix3f frame = frameAround(hit.normal);
    const Vec3f place = hit.point + studio_.middle;
    const GroundLook look =
        groundLook(studio_.style.ground, frame.col(0).dot(place), frame.col(1).dot(place));
    at.colour = look.colour;
    at.glaze = look.glaze;
    at.roughness = look.roughness;
    return at;
  }
  if (hit.look->grainy) at.normal = grainyNormal(hit);
  at.colour = hit.look->colour;
  at.glaze = hit.look->glaze;
  at.roughness = hit.look->roughness;
  return at;
}

/// Light that a white surface would reflect if nothing stood in the way.
struct PathTracer::Lamp {
  Light light = Light::Zero();
  Vec3f direction = Vec3f::UnitZ();
  float distance = std::numeric_limits<float>::infinity();
};

PathTracer::Lamp PathTracer::lampOf(const SoftBox& box, const Shading& at,
                                    const std::array<float, 2>& random) {
  Lamp lamp;
  const Vec3f offset = box.pointAt(random) - at.point;
  lamp.distance = offset.norm();
  lamp.direction = offset / lamp.distance;
  const float falling = at.normal.dot(lamp.direction);
  const float leaving = -box.front.dot(lamp.direction);
  if (falling > 0.0F && leaving > 0.0F)
    lamp.light =
        box.radianceAt(random) * (falling * leaving * box.area / (kPi * lamp.distance * lamp.distance));
  return lamp;
}

PathTracer::Lamp PathTracer::lampOf(const EnvironmentMap& environment, const Shading& at,
                                    const std::array<float, 2>& random) {
  const EnvironmentMap::Sample sample = environment.sample(random);
  Lamp lamp;
  lamp.direction = sample.direction;
  const float falling = at.normal.dot(sample.direction);
  if (falling > 0.0F && at.facing.dot(sample.direction) > 0.0F)
    lamp.light = environment.radiance(sample.direction) * (falling / (kPi * sample.density));
  return lamp;
}

Light PathTracer::arriving(const Lamp& lamp, const Shading& at, float time) const {
  if (!(lamp.light > 0.0F).any()) return Light::Zero();
  return lamp.light * scene_.transmitted(at.point, lamp.direction, lamp.distance, time);
}

/// From both lamps, or two samples of the environment.
Light PathTracer::directLight(const Shading& at, float time, const PixelSampler& sampler) const {
  const auto first = sampler.pair(kKey);
  const auto second = sampler.pair(kFill);
  if (const EnvironmentMap* around = studio_.environment.get())
    return 0.5F *
           (arriving(lampOf(*around, at, first), at, time) + arriving(lampOf(*around, at, second), at, time));
  return arriving(lampOf(studio_.lights[0], at, first), at, time) +
         arriving(lampOf(studio_.lights[1], at, second), at, time);
}

/// One of the two lamps, chosen by the first number, which is then stretched to serve again.
Light PathTracer::oneLight(const Shading& at, float time, std::array<float, 2> random) const {
  if (studio_.environment) return arriving(lampOf(*studio_.environment, at, random), at, time);
  constexpr float kKeyShare = 0.7F;
  const bool key = random[0] < kKeyShare;
  random[0] = key ? random[0] / kKeyShare : (random[0] - kKeyShare) / (1.0F - kKeyShare);
  const Light light = arriving(lampOf(studio_.lights[key ? 0 : 1], at, random), at, time);
  return light / (key ? kKeyShare : 1.0F - kKeyShare);
}

/// What a ground that shows shadows only keeps of the backdrop: less by the share of its light that things
/// take away.
Light PathTracer::shadowed(const SurfaceHit& hit, const Vec3f& direction, float time,
                           const PixelSampler& sampler) const {
  const Shading at = shadingAt(hit);
  Light all = studio_.domeFromAbove;
  const Vec3f up = frameAround(at.normal) * cosineHemisphere(sampler.pair(kBounce));
  const Light high = studio_.environment ? Light(Light::Zero()) : studio_.dome(up);
  Light taken = high - arriving({high, up}, at, time);
  const auto add = [&](const Lamp& lamp, float weight) {
    taken += weight * (lamp.light - arriving(lamp, at, time));
  };
  if (const EnvironmentMap* around = studio_.environment.get()) {
    all = around->fromAbove();
    add(lampOf(*around, at, sampler.pair(kKey)), 0.5F);
    add(lampOf(*around, at, sampler.pair(kFill)), 0.5F);
  } else {
    for (const SoftBox& box : studio_.lights) {
      constexpr int kAcross = 4;
      for (int cell = 0; cell < kAcross * kAcross; ++cell) {
        const int row = cell / kAcross;
        const std::array<float, 2> middle{(static_cast<float>(cell % kAcross) + 0.5F) / kAcross,
                                          (static_cast<float>(row) + 0.5F) / kAcross};
        all += lampOf(box, at, middle).light / (kAcross * kAcross);
      }
    }
    add(lampOf(studio_.lights[0], at, sampler.pair(kKey)), 1.0F);
    add(lampOf(studio_.lights[1], at, sampler.pair(kFill)), 1.0F);
  }
  return studio_.backdrop(direction) * (1.0F - brightness(taken) / std::max(1e-6F, brightness(all)));
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
  // The environment has been asked where the path came from.
  return studio_.environment ? Light(Light::Zero()) : studio_.dome(path.direction);
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
  path.density = mirrorDensity(at, path.direction, mirrored);
  path.origin = at.point;
  path.direction = mirrored;
  path.sees = Path::Sees::room;
  path.blurred = path.blurred || at.roughness > kBlurring;
}

/// With which mirror() sends a path on, per steradian (Heitz 2018, equations 2, 3 and 17). Its share is
/// Fresnel's, so that what a glaze reflects of the environment is that times this.
float PathTracer::mirrorDensity(const Shading& at, const Vec3f& direction, const Vec3f& mirrored) {
  const Vec3f half = (mirrored - direction).normalized();
  const float viewed = std::abs(at.normal.dot(direction));
  const float upright = at.normal.dot(half);
  const float squared = at.roughness * at.roughness;
  const float spread = upright * upright * (squared - 1.0F) + 1.0F;
  const float visible = 2.0F / (viewed + std::sqrt(squared + (1.0F - squared) * viewed * viewed));
  return squared / (kPi * spread * spread) * visible / 4.0F;
}

/// The share of an estimate among two that may both find a direction (Veach's balance heuristic).
float PathTracer::mirrorShare(const Path& path) const {
  if (!studio_.environment || !(path.density > 0.0F)) return 1.0F;
  return path.density / (path.density + studio_.environment->density(path.direction));
}

/// What a glaze mirrors of small bright lights, which mirrored paths seldom meet.
Light PathTracer::glossFrom(const EnvironmentMap& around, const Shading& at, const Vec3f& direction,
                            float time, const std::array<float, 2>& random) const {
  const EnvironmentMap::Sample sample = around.sample(random);
  if (at.normal.dot(sample.direction) <= 0.0F || at.facing.dot(sample.direction) <= 0.0F)
    return Light::Zero();
  const float density = mirrorDensity(at, direction, sample.direction);
  const Vec3f half = (sample.direction - direction).normalized();
  const float weight = fresnel(std::abs(direction.dot(half))) * density / (density + sample.density);
  Lamp lamp;
  lamp.light = weight * around.radiance(sample.direction);
  lamp.direction = sample.direction;
  return arriving(lamp, at, time);
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
    if (!hit) {
      const Light seen = path.share * sky(path);
      return light + mirrorShare(path) * (path.chosen ? Light(seen.min(kBrightestIndirect)) : seen);
    }
    path.density = 0.0F;
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
    // A weak reflection that is seldom chosen would be noise: after scattering, and of or in a rough floor
    // that takes part in a mirror image, it goes with the rest.
    const bool isBlur = path.blurred || (path.sees == Path::Sees::room && at.roughness > kBlurring);
    if (scatterings == 0 && !isBlur && choice < mirrored) {
      const Vec3f before = path.direction;
      const Light share = path.share;
      mirror(at, sampler.pair(path.dimension + kDirection), path);
      path.density = 0.0F;
      path.chosen = true;
      path.share = share * fresnel(std::abs(at.normal.dot(before))) * at.glaze / mirrored;
      continue;
    }
    path.share *= at.colour;
    light += path.share * oneLight(at, path.time, sampler.pair(path.dimension + kLight));
    if (++scatterings > kMostScatterings) return light + path.share * studio_.ambient;
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
  if (hit->look == nullptr && studio_.style.ground.kind == modeling::GroundKind::shadow) {
    exposure.rest = shadowed(*hit, direction, time, sampler);
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
  exposure.rest = exposure.colour * directLight(at, time, sampler);
  if (at.glaze > 0.0F) {
    Path path{origin, direction, time};
    mirror(at, sampler.pair(kMirror), path);
    // Its own numbers, apart from the scattered path's.
    path.dimension += kMostSurfaces * kSurfaceDimensions;
    exposure.rest += at.glaze * followed(path, sampler);
    if (studio_.environment) {
      const auto gloss = [&](Dimension dimension) {
        return glossFrom(*studio_.environment, at, direction, time, sampler.pair(dimension));
      };
      exposure.rest += 0.5F * at.glaze * (gloss(kKey) + gloss(kFill));
    }
  }
  if (share < 1.0F) exposure.rest += (1.0F - share) * studio_.backdrop(direction);
  exposure.point = hit->point;
  exposure.normal = at.normal;
  return exposure;
}

}  // namespace ui
