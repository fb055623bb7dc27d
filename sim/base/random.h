#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace sim {

/// SplitMix64's finalizer: a bijection of 64 bits in which every input bit moves every output bit.
/// Counter-based, so that the number drawn for a thing depends on the seed and the thing alone, never on who
/// drew before it.
inline std::uint64_t mixBits(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15ULL;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9ULL;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebULL;
  return value ^ (value >> 31);
}

/// Uniform in (0, 1), never either end.
inline double uniformAt(std::uint64_t seed, std::uint64_t counter) {
  const std::uint64_t bits = mixBits(mixBits(seed) ^ counter) >> 11;
  return (static_cast<double>(bits) + 0.5) * 0x1.0p-53;
}

/// Standard normal, by Box and Muller from two uniform draws.
inline double normalAt(std::uint64_t seed, std::uint64_t counter) {
  const double radius = std::sqrt(-2.0 * std::log(uniformAt(seed, 2 * counter)));
  return radius * std::cos(2.0 * std::numbers::pi * uniformAt(seed, 2 * counter + 1));
}

}  // namespace sim
