#pragma once

#include <string_view>

#include "sim/collider/collider_drawing.h"
#include "sim/collider/intrusion.h"

namespace sim {

/// A box about the collider's origin, along its axes.
struct BoxShape {
  static constexpr std::string_view kName = "box";

  Vec3 halfSize = Vec3::Ones();  ///< half edges, cm

  Intrusion intrusion(const Vec3& local, std::uint32_t) const;
  double middleDepth() const { return halfSize.minCoeff(); }
  double reach() const { return halfSize.norm(); }
  ColliderSurface surface() const;
  ColliderOutline outline() const;
  /// Makes it larger by a factor along each of its axes, as far as it can be.
  void scale(const Vec3& factors) { halfSize = halfSize.cwiseProduct(factors); }

  bool operator==(const BoxShape&) const = default;
};

}  // namespace sim
