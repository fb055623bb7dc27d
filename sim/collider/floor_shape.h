#pragma once

#include <limits>
#include <string_view>

#include "sim/collider/collider_drawing.h"
#include "sim/collider/intrusion.h"

namespace sim {

/// The half-space below z = 0 of the collider's own coordinates, without an end.
struct FloorShape {
  static constexpr std::string_view kName = "floor";

  Intrusion intrusion(const Vec3& local, std::uint32_t) const { return {-local.z(), Vec3::UnitZ()}; }
  double middleDepth() const { return std::numeric_limits<double>::infinity(); }
  double reach() const { return std::numeric_limits<double>::max(); }
  /// Nothing: what draws a floor lets it end where nobody looks.
  ColliderSurface surface() const { return {}; }
  /// A square that stands for the whole.
  ColliderOutline outline() const;
  void scale(const Vec3&) {}

  bool operator==(const FloorShape&) const = default;
};

}  // namespace sim
