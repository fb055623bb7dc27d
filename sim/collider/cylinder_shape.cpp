#include "sim/collider/cylinder_shape.h"

namespace sim {

Intrusion CylinderShape::intrusion(const Vec3& local, std::uint32_t) const {
  const double distance = std::hypot(local.x(), local.y());
  const double side = radius - distance;
  const double end = halfHeight - std::abs(local.z());
  if (end < side) return {end, Vec3(0.0, 0.0, local.z() < 0.0 ? -1.0 : 1.0)};
  if (distance > 0.0) return {side, Vec3(local.x() / distance, local.y() / distance, 0.0)};
  return {side, Vec3::UnitX()};
}

ColliderSurface CylinderShape::surface() const {
  ColliderSurface surface;
  surface.addTurned(1, [&](double angle, double share) {
    const Vec3 normal(std::cos(angle), std::sin(angle), 0.0);
    surface.addPoint(radius * normal + (2.0 * share - 1.0) * halfHeight * Vec3::UnitZ(), normal);
  });
  for (const double side : {-1.0, 1.0}) {
    surface.addTurned(1, [&](double turned, double share) {
      const double angle = side * turned;
      const double distance = radius * (1.0 - share);
      surface.addPoint({distance * std::cos(angle), distance * std::sin(angle), side * halfHeight},
                       side * Vec3::UnitZ());
    });
  }
  return surface;
}

ColliderOutline CylinderShape::outline() const {
  const Vec3 x = radius * Vec3::UnitX();
  const Vec3 y = radius * Vec3::UnitY();
  const Vec3 up = halfHeight * Vec3::UnitZ();
  ColliderOutline outline;
  for (const double side : {-1.0, 1.0}) addEllipse(side * up, x, y, outline);
  for (const Vec3& at : {x, y, Vec3(-x), Vec3(-y)}) outline.push_back({at - up, at + up});
  return outline;
}

}  // namespace sim
