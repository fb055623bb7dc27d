#pragma once

#include <algorithm>
#include <cmath>
#include <string_view>

#include "sim/collider/collider_drawing.h"
#include "sim/collider/intrusion.h"

namespace sim {

/// A solid cylinder about the collider's origin, along its z.
struct CylinderShape {
  static constexpr std::string_view kName = "cylinder";

  double radius = 1.0;      ///< cm
  double halfHeight = 1.0;  ///< cm

  Intrusion intrusion(const Vec3& local, std::uint32_t) const;
  double middleDepth() const { return std::min(radius, halfHeight); }
  double reach() const { return std::hypot(radius, halfHeight); }
  ColliderSurface surface() const;
  ColliderOutline outline() const;
  /// Makes it larger by a factor along each of its axes, as far as it can be.
  void scale(const Vec3& factors) {
    radius *= std::sqrt(factors.x() * factors.y());
    halfHeight *= factors.z();
  }

  bool operator==(const CylinderShape&) const = default;
};

}  // namespace sim
