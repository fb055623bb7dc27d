#include "ui/picture/ground_pattern.h"

#include <algorithm>

#include "sim/base/random.h"

namespace ui {

namespace {

/// The studio's floor.
const Light kStudioFloor(0.215F, 0.200F, 0.187F);

constexpr modeling::Colour kLight{0.62, 0.60, 0.57};
constexpr modeling::Colour kDark{0.36, 0.34, 0.32};
constexpr modeling::Colour kWood{0.60, 0.43, 0.28};
constexpr modeling::Colour kWoodGrain{0.36, 0.23, 0.14};

/// In [0, 1), of a plank's numbers.
float chance(float first, float second, float which) {
  const auto key = static_cast<std::uint64_t>(static_cast<std::int64_t>(first) * 7919 +
                                              static_cast<std::int64_t>(second) * 104729 +
                                              static_cast<std::int64_t>(which) * 1299709);
  return static_cast<float>(sim::mixBits(key) >> 40U) * 0x1.0p-24F;
}

/// Planks side by side, each a dozen widths long, begun anywhere; rings of growth cut along the stem.
GroundLook wood(const modeling::Ground& ground, float across, float along) {
  constexpr float kLength = 12.0F;   // of a plank, in widths
  constexpr float kJoint = 0.012F;   // in widths
  constexpr float kStretch = 0.07F;  // grain along a plank, relative to across it
  const auto width = static_cast<float>(ground.size);
  const float row = std::floor(across / width);
  const float start = along / (kLength * width) + chance(row, 0.0F, 1.0F);
  const float plank = std::floor(start);
  const float sideways = across / width - row;
  const float lengthways = (start - plank) * kLength;
  const Vec3f grainAt(9.0F * sideways, 9.0F * kStretch * lengthways, 50.0F * chance(row, plank, 2.0F));
  const float rings = 0.5F + 0.5F * std::sin(14.0F * (noise(0.35F * grainAt) + 0.2F * noise(grainAt)));
  const float fibre = noise(Vec3f(70.0F * sideways, 5.0F * lengthways, grainAt.z()));
  const float grain = std::clamp(0.42F * rings + 0.16F * fibre + 0.12F, 0.0F, 1.0F);
  const float tone = 0.82F + 0.32F * chance(row, plank, 3.0F);
  const Light light = linearFromSrgb(ground.colour.value_or(kWood));
  const Light dark = linearFromSrgb(ground.second.value_or(kWoodGrain));
  const float edge = std::min({sideways, 1.0F - sideways, lengthways, kLength - lengthways});
  const float joint = 0.35F + 0.65F * smoothStep(0.25F * kJoint, kJoint, edge);
  return {joint * tone * (light + grain * (dark - light)), 0.30F, 0.28F};
}

}  // namespace

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

GroundLook groundLook(const modeling::Ground& ground, float across, float along) {
  const auto size = static_cast<float>(ground.size);
  switch (ground.kind) {
    case modeling::GroundKind::plain:
      return {linearFromSrgb(ground.colour.value_or(kLight))};
    case modeling::GroundKind::checker: {
      const bool even =
          std::fmod(std::abs(std::floor(across / size) + std::floor(along / size)), 2.0F) < 0.5F;
      return {linearFromSrgb(even ? ground.colour.value_or(kLight) : ground.second.value_or(kDark))};
    }
    case modeling::GroundKind::wood:
      return wood(ground, across, along);
    case modeling::GroundKind::studio:
    case modeling::GroundKind::none:
    case modeling::GroundKind::shadow:
      break;
  }
  return {kStudioFloor};
}

}  // namespace ui
