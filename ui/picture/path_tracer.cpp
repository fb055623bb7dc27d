#include "ui/picture/path_tracer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/base/random.h"

namespace ui {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

/// Reflectance of a glaze of refractive index 1.5 seen straight on.
constexpr float kStraightReflectance = 0.04F;

/// Indirect light is cut here, so that no lucky path leaves a bright dot.
constexpr float kBrightestIndirect = 3.0F;

/// What a second bounce finds of light that has bounced more often: a share of the dome's.
constexpr float kAmbient = 0.28F;

/// Dimensions of a sample, so that each decision is spread on its own. 0 is the pixel's.
enum Dimension : std::uint32_t { kFirstKey = 1, kFirstFill, kBounce, kSecondLight, kMirror, kMirrorLight };

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

}  // namespace

struct PathTracer::Shading {
  Vec3f point;
  Vec3f facing;
  Vec3f normal;
  Light colour;
  float glaze = 0.0F;
  float roughness = 0.0F;
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

Light PathTracer::lightFrom(const SoftBox& box, const Shading& at, const std::array<float, 2>& random) const {
  const Vec3f offset = box.pointAt(random) - at.point;
  const float distance = offset.norm();
  const Vec3f direction = offset / distance;
  const float falling = at.normal.dot(direction);
  const float leaving = -box.front.dot(direction);
  if (falling <= 0.0F || leaving <= 0.0F) return Light::Zero();
  if (scene_.isBlocked(at.point, direction, distance)) return Light::Zero();
  return box.radianceAt(random) * (falling * leaving * box.area / (kPi * distance * distance));
}

Light PathTracer::secondary(const SurfaceHit& hit, const Vec3f& direction, const PixelSampler& sampler,
                            std::uint32_t dimension) const {
  const Shading at = shadingAt(hit);
  if (hit.look == nullptr && floorShare(hit) <= 0.0F) return studio_.backdrop(direction);
  // One of the two lights, chosen by the first number, which is then stretched to serve again.
  std::array<float, 2> random = sampler.pair(dimension);
  constexpr float kKeyShare = 0.7F;
  const bool key = random[0] < kKeyShare;
  random[0] = key ? random[0] / kKeyShare : (random[0] - kKeyShare) / (1.0F - kKeyShare);
  const Light direct =
      lightFrom(studio_.lights[key ? 0 : 1], at, random) / (key ? kKeyShare : 1.0F - kKeyShare);
  return faded(hit, direction, at.colour * (direct + kAmbient));
}

Light PathTracer::directLight(const Shading& at, const PixelSampler& sampler) const {
  return lightFrom(studio_.lights[0], at, sampler.pair(kFirstKey)) +
         lightFrom(studio_.lights[1], at, sampler.pair(kFirstFill));
}

Light PathTracer::indirectLight(const Shading& at, const PixelSampler& sampler) const {
  const Vec3f bounce = frameAround(at.normal) * cosineHemisphere(sampler.pair(kBounce));
  if (at.facing.dot(bounce) <= 0.0F) return Light::Zero();
  const auto hit = scene_.nearest(at.point, bounce);
  const Light light = hit ? secondary(*hit, bounce, sampler, kSecondLight) : studio_.dome(bounce);
  return light.min(kBrightestIndirect);
}

Light PathTracer::mirrored(const Shading& at, const Vec3f& direction, const PixelSampler& sampler) const {
  const Eigen::Matrix3f frame = frameAround(at.normal);
  const Vec3f view = frame.transpose() * -direction;
  const Vec3f half = frame * visibleGgxNormal(view, at.roughness, sampler.pair(kMirror));
  Vec3f mirror = direction - 2.0F * direction.dot(half) * half;
  // Near the outline a shading normal can send the ray under the surface: let it graze instead.
  if (const float depth = mirror.dot(at.facing); depth <= 0.0F)
    mirror = (mirror + (0.01F - depth) * at.facing).normalized();
  const float reflectance = fresnel(std::abs(direction.dot(half)));
  const auto hit = scene_.nearest(at.point, mirror);
  const Light seen =
      hit ? secondary(*hit, mirror, sampler, kMirrorLight) : studio_.reflected(at.point, mirror);
  return reflectance * seen;
}

float PathTracer::floorShare(const SurfaceHit& hit) const {
  const float reach = hit.point.norm();
  return 1.0F - smoothStep(studio_.fadeFrom, studio_.fadeTo, reach);
}

Light PathTracer::faded(const SurfaceHit& hit, const Vec3f& direction, const Light& light) const {
  if (hit.look != nullptr) return light;
  const Light backdrop = studio_.backdrop(direction);
  return backdrop + floorShare(hit) * (light - backdrop);
}

Exposure PathTracer::expose(const Vec3f& origin, const Vec3f& direction, const PixelSampler& sampler) const {
  Exposure exposure;
  const auto hit = scene_.nearest(origin, direction);
  if (!hit || (hit->look == nullptr && floorShare(*hit) <= 0.0F)) {
    exposure.rest = studio_.backdrop(direction);
    return exposure;
  }
  const Shading at = shadingAt(*hit);
  const float share = hit->look == nullptr ? floorShare(*hit) : 1.0F;
  const float through = 1.0F - at.glaze * fresnel(std::abs(at.normal.dot(direction)));
  exposure.colour = share * through * at.colour;
  exposure.indirect = indirectLight(at, sampler);
  exposure.rest = exposure.colour * directLight(at, sampler);
  if (at.glaze > 0.0F) exposure.rest += at.glaze * mirrored(at, direction, sampler);
  if (share < 1.0F) exposure.rest += (1.0F - share) * studio_.backdrop(direction);
  exposure.point = hit->point;
  exposure.normal = at.normal;
  return exposure;
}

}  // namespace ui
