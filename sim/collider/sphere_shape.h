#pragma once

#include <cmath>
#include <string_view>

#include "sim/collider/collider_drawing.h"
#include "sim/collider/intrusion.h"

namespace sim {

/// A ball about the collider's origin.
struct SphereShape {
  static constexpr std::string_view kName = "sphere";

  double radius = 1.0;  ///< cm

  Intrusion intrusion(const Vec3& local, std::uint32_t) const;
  double middleDepth() const { return radius; }
  double reach() const { return radius; }
  ColliderSurface surface() const;
  ColliderOutline outline() const;
  /// Makes it larger by a factor along each of its axes, as far as it can be.
  void scale(const Vec3& factors) { radius *= std::cbrt(factors.prod()); }

  bool operator==(const SphereShape&) const = default;
};

}  // namespace sim
