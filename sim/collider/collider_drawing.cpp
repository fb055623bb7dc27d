#include "sim/collider/collider_drawing.h"

namespace sim {

void ColliderSurface::addFlat(const std::array<Vec3, 4>& corners, const Vec3& normal) {
  const auto first = static_cast<std::uint32_t>(points.size());
  for (const Vec3& corner : corners) addPoint(corner, normal);
  quads.push_back({first, first + 1, first + 2, first + 3});
}

void ColliderSurface::addGrid(std::uint32_t first, std::uint32_t around, std::uint32_t along) {
  const std::uint32_t row = around + 1;
  for (std::uint32_t j = 0; j < along; ++j) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t corner = first + j * row + i;
      quads.push_back({corner, corner + 1, corner + row + 1, corner + row});
    }
  }
}

void addEllipse(const Vec3& middle, const Vec3& x, const Vec3& y, ColliderOutline& outline) {
  constexpr std::size_t kAround = 48;
  const auto at = [&](std::size_t i) -> Vec3 {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(kAround);
    return middle + std::cos(angle) * x + std::sin(angle) * y;
  };
  for (std::size_t i = 0; i < kAround; ++i) outline.push_back({at(i), at(i + 1)});
}

void addBoxEdges(const Vec3& halfSize, ColliderOutline& outline) {
  const auto corner = [&](unsigned c) -> Vec3 {
    return {((c & 1U) ? 1.0 : -1.0) * halfSize.x(), ((c & 2U) ? 1.0 : -1.0) * halfSize.y(),
            ((c & 4U) ? 1.0 : -1.0) * halfSize.z()};
  };
  for (unsigned c = 0; c < 8; ++c) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      if (((c >> axis) & 1U) == 0) outline.push_back({corner(c), corner(c | (1U << axis))});
    }
  }
}

}  // namespace sim
