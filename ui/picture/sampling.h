#pragma once

#include <array>
#include <cstdint>

#include "ui/picture/linear.h"

namespace ui {

/// Well-spread points in many dimensions for one pixel: Owen-scrambled Sobol pairs, padded (Burley,
/// "Practical hash-based Owen scrambling", 2020). A function of seed, dimension and index alone, so that a
/// picture does not depend on which thread drew what.
class PixelSampler {
 public:
  explicit PixelSampler(std::uint32_t seed) : seed_(seed) {}

  void startSample(std::uint32_t index) { index_ = index; }
  /// In [0, 1)^2; every dimension is spread on its own.
  std::array<float, 2> pair(std::uint32_t dimension) const;

 private:
  std::uint32_t seed_;
  std::uint32_t index_ = 0;
};

/// About z, with density cos/pi.
Vec3f cosineHemisphere(const std::array<float, 2>& random);

/// Half vector about z of the visible GGX normals for a view direction in the same frame (Heitz 2018).
Vec3f visibleGgxNormal(const Vec3f& view, float alpha, const std::array<float, 2>& random);

/// An offset in pixels distributed as a filter of radius 1.5 (a Blackman-Harris window's bell): a pixel that
/// averages such samples is filtered, without sharing them between pixels.
std::array<float, 2> filterOffset(const std::array<float, 2>& random);

}  // namespace ui
