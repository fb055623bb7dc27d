#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "sim/base/types.h"

/// What a kind of collider looks like, stated once for the window and for ray-traced pictures.
namespace sim {

/// A surface of quadrilaterals in the collider's own coordinates.
struct ColliderSurface {
  std::vector<Vec3> points;                         ///< cm
  std::vector<Vec3> normals;                        ///< unit, outward, one a point
  std::vector<std::array<std::uint32_t, 4>> quads;  ///< a triangle repeats its last corner

  /// Adds a point, which no quadrilateral has yet.
  void addPoint(const Vec3& point, const Vec3& normal) {
    points.push_back(point);
    normals.push_back(normal);
  }

  /// Adds a flat quadrilateral, counter-clockwise seen from outside.
  void addFlat(const std::array<Vec3, 4>& corners, const Vec3& normal);

  /// Adds what is swept when an angle goes round from 0 to 2 pi and a share goes from 0 to 1 in `along`
  /// steps: addPointAt(angle, share) adds one point of it. Where the angle turns counter-clockwise about z
  /// and the share goes up, the outside is out.
  template <class AddPointAt>
  void addTurned(std::uint32_t along, const AddPointAt& addPointAt);

 private:
  void addGrid(std::uint32_t first, std::uint32_t around, std::uint32_t along);
};

/// Lines that show a collider's form, from and to, cm.
using ColliderOutline = std::vector<std::array<Vec3, 2>>;

/// Adds the ellipse about `middle` through middle + x and middle + y.
void addEllipse(const Vec3& middle, const Vec3& x, const Vec3& y, ColliderOutline& outline);
/// Adds the twelve edges of a box about the origin.
void addBoxEdges(const Vec3& halfSize, ColliderOutline& outline);

/// Steps of a turned surface: so fine that the polygon shows neither at the outline nor, with smooth normals,
/// in the shading.
inline constexpr std::uint32_t kDrawnAround = 128;

template <class AddPointAt>
void ColliderSurface::addTurned(std::uint32_t along, const AddPointAt& addPointAt) {
  const auto first = static_cast<std::uint32_t>(points.size());
  for (std::uint32_t j = 0; j <= along; ++j) {
    for (std::uint32_t i = 0; i <= kDrawnAround; ++i)
      addPointAt(2.0 * std::numbers::pi * i / kDrawnAround, static_cast<double>(j) / along);
  }
  addGrid(first, kDrawnAround, along);
}

}  // namespace sim
