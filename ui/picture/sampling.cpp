#include "ui/picture/sampling.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ui {

namespace {

constexpr float kPi = std::numbers::pi_v<float>;

std::uint32_t reverseBits(std::uint32_t x) {
  x = (x << 16U) | (x >> 16U);
  x = ((x & 0x00ff00ffU) << 8U) | ((x & 0xff00ff00U) >> 8U);
  x = ((x & 0x0f0f0f0fU) << 4U) | ((x & 0xf0f0f0f0U) >> 4U);
  x = ((x & 0x33333333U) << 2U) | ((x & 0xccccccccU) >> 2U);
  return ((x & 0x55555555U) << 1U) | ((x & 0xaaaaaaaaU) >> 1U);
}

std::uint32_t hash(std::uint32_t a, std::uint32_t b) {
  std::uint32_t x = a ^ (b * 0x9e3779b9U + 0x7f4a7c15U);
  x = (x ^ (x >> 16U)) * 0x7feb352dU;
  x = (x ^ (x >> 15U)) * 0x846ca68bU;
  return x ^ (x >> 16U);
}

/// Every bit flips by a hash of the bits above it (Laine and Karras).
std::uint32_t owenScramble(std::uint32_t x, std::uint32_t seed) {
  x = reverseBits(x) + seed;
  x ^= x * 0x6c50b47cU;
  x ^= x * 0xb82f1e52U;
  x ^= x * 0xc7afe638U;
  x ^= x * 0x8d22f6e6U;
  return reverseBits(x);
}

std::uint32_t secondSobol(std::uint32_t index) {
  std::uint32_t result = 0;
  for (std::uint32_t direction = 1U << 31U; index != 0; index >>= 1U, direction ^= direction >> 1U) {
    if ((index & 1U) != 0) result ^= direction;
  }
  return result;
}

float unitFloat(std::uint32_t bits) {
  return static_cast<float>(bits >> 8U) * 0x1.0p-24F;
}

}  // namespace

std::array<float, 2> PixelSampler::pair(std::uint32_t dimension) const {
  const std::uint32_t seed = hash(seed_, dimension);
  const std::uint32_t shuffled = owenScramble(index_, seed);
  return {unitFloat(owenScramble(reverseBits(shuffled), hash(seed, 1))),
          unitFloat(owenScramble(secondSobol(shuffled), hash(seed, 2)))};
}

Vec3f cosineHemisphere(const std::array<float, 2>& random) {
  const float radius = std::sqrt(random[0]);
  const float angle = 2.0F * kPi * random[1];
  return {radius * std::cos(angle), radius * std::sin(angle), std::sqrt(std::max(0.0F, 1.0F - random[0]))};
}

Vec3f visibleGgxNormal(const Vec3f& view, float alpha, const std::array<float, 2>& random) {
  const Vec3f stretched = Vec3f(alpha * view.x(), alpha * view.y(), view.z()).normalized();
  const float length = std::hypot(stretched.x(), stretched.y());
  const Vec3f first =
      length > 1e-6F ? Vec3f(-stretched.y() / length, stretched.x() / length, 0.0F) : Vec3f::UnitX();
  const Vec3f second = stretched.cross(first);
  const float radius = std::sqrt(random[0]);
  const float angle = 2.0F * kPi * random[1];
  const float x = radius * std::cos(angle);
  const float share = 0.5F * (1.0F + stretched.z());
  const float y = (1.0F - share) * std::sqrt(std::max(0.0F, 1.0F - x * x)) + share * radius * std::sin(angle);
  const float z = std::sqrt(std::max(0.0F, 1.0F - x * x - y * y));
  const Vec3f normal = x * first + y * second + z * stretched;
  return Vec3f(alpha * normal.x(), alpha * normal.y(), std::max(0.0F, normal.z())).normalized();
}

// A Blackman-Harris window three pixels wide is close to a Gaussian of deviation 0.42 pixels, which can be
// drawn exactly.
std::array<float, 2> filterOffset(const std::array<float, 2>& random) {
  constexpr float kDeviation = 0.42F;
  constexpr float kReach = 1.5F;
  const float radius = std::min(kReach, kDeviation * std::sqrt(-2.0F * std::log(1.0F - random[0])));
  const float angle = 2.0F * kPi * random[1];
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

}  // namespace ui
