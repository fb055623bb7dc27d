#include "ui/picture/studio.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

/// The room in units of the subject's size (half its box's diagonal). The key is small enough for a crisp
/// highlight on a glaze and large enough that shadows soften within a hand's breadth. It is so bright that
/// white porcelain stays below full white, and its highlights do not.
constexpr float kKeyDistance = 4.2F;
constexpr float kKeyHalfSize = 0.55F;
constexpr float kFillDistance = 4.5F;
constexpr float kFillHalfWidth = 0.28F;
constexpr float kFillHalfHeight = 1.7F;
constexpr float kFadeFrom = 2.5F;
constexpr float kFadeTo = 14.0F;

/// What comes from surfaces that are no longer followed: a share of the dome's light, or of the
/// environment's.
constexpr float kAmbient = 0.28F;
constexpr float kAmbientShare = 0.7F;

/// The mean over the upper hemisphere, weighted by the cosine. The dome is the same all around.
Light domeFromAbove(const Studio& studio) {
  constexpr int kBands = 64;
  Light sum = Light::Zero();
  for (int band = 0; band < kBands; ++band) {
    // Bands of equal weight: the cosine squared is spread evenly.
    const float height = std::sqrt((static_cast<float>(band) + 0.5F) / kBands);
    sum += studio.dome(Vec3f(std::sqrt(1.0F - height * height), 0.0F, height)) / kBands;
  }
  return sum;
}

SoftBox aimedBox(const Vec3f& direction, float distance, float halfWidth, float halfHeight,
                 const Light& irradiance) {
  SoftBox box;
  box.front = -direction.normalized();
  box.centre = -distance * box.front;
  box.halfAcross = halfWidth * Vec3f::UnitZ().cross(box.front).normalized();
  box.halfUp = halfHeight * box.front.cross(box.halfAcross).normalized();
  box.area = 4.0F * halfWidth * halfHeight;
  box.radiance = irradiance * distance * distance / box.area;
  return box;
}

}  // namespace

Light SoftBox::radianceAt(float across, float up) const {
  const float edge = std::max(std::abs(across), std::abs(up));
  return radiance * (1.0F - smoothStep(0.8F, 1.0F, edge)) *
         (1.0F - 0.3F * (across * across + up * up) / 2.0F);
}

Light Studio::backdrop(const Vec3f& direction) const {
  switch (style.backdrop.kind) {
    case modeling::BackdropKind::colour:
      return linearFromSrgb(style.backdrop.colour);
    case modeling::BackdropKind::gradient: {
      const Light horizon = linearFromSrgb(style.backdrop.colour);
      return horizon + (linearFromSrgb(style.backdrop.top) - horizon) * smoothStep(0.0F, 0.6F, direction.z());
    }
    case modeling::BackdropKind::environment:
      if (environment) return environment->radiance(direction);
      break;
    case modeling::BackdropKind::studio:
      break;
  }
  const Light low(0.112F, 0.106F, 0.102F);
  const Light high(0.020F, 0.021F, 0.023F);
  return low + (high - low) * smoothStep(-0.25F, 0.5F, direction.z());
}

Light Studio::dome(const Vec3f& direction) const {
  const Light low(0.12F, 0.115F, 0.11F);
  const Light overhead(0.40F, 0.41F, 0.43F);
  return low + (overhead - low) * smoothStep(0.0F, 1.0F, direction.z());
}

Light Studio::reflected(const Vec3f& origin, const Vec3f& direction) const {
  if (environment) return environment->radiance(direction);
  for (const SoftBox& box : lights) {
    const float facing = -direction.dot(box.front);
    if (facing <= 0.0F) continue;
    const float distance = (origin - box.centre).dot(box.front) / facing;
    if (distance <= 0.0F) continue;
    const Vec3f offset = origin + distance * direction - box.centre;
    const float across = offset.dot(box.halfAcross) / box.halfAcross.squaredNorm();
    const float up = offset.dot(box.halfUp) / box.halfUp.squaredNorm();
    if (std::abs(across) < 1.0F && std::abs(up) < 1.0F) return box.radianceAt(across, up) + dome(direction);
  }
  return dome(direction);
}

Studio arrangeStudio(const Camera& camera, const Box& subject, const modeling::PictureStyle& style,
                     std::shared_ptr<const EnvironmentMap> environment) {
  const float size = std::max(1e-3F, static_cast<float>(subject.diagonal().norm() / 2.0));
  Vec3f towardsCamera = (camera.position - camera.target).cast<float>();
  towardsCamera.z() = 0.0F;
  towardsCamera = towardsCamera.norm() > 0.0F ? Vec3f(towardsCamera.normalized()) : -Vec3f::UnitY();
  const Vec3f right = Vec3f::UnitZ().cross(towardsCamera);
  const Vec3f up = Vec3f::UnitZ();

  Studio studio;
  studio.lights[0] = aimedBox(-0.78F * right + 0.80F * up + 0.66F * towardsCamera, kKeyDistance * size,
                              kKeyHalfSize * size, kKeyHalfSize * size, Light(3.05F, 2.95F, 2.78F));
  studio.lights[1] = aimedBox(1.0F * right + 0.35F * up + 0.15F * towardsCamera, kFillDistance * size,
                              kFillHalfWidth * size, kFillHalfHeight * size, Light(0.50F, 0.54F, 0.60F));
  studio.fadeFrom = kFadeFrom * size;
  studio.fadeTo = kFadeTo * size;
  studio.style = style;
  studio.middle = subject.center().cast<float>();
  studio.domeFromAbove = domeFromAbove(studio);
  studio.ambient = environment ? Light(kAmbientShare * environment->mean()) : Light::Constant(kAmbient);
  studio.environment = std::move(environment);
  return studio;
}

}  // namespace ui
