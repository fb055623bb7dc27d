#include "sim/collider/sphere_shape.h"

namespace sim {

Intrusion SphereShape::intrusion(const Vec3& local, std::uint32_t) const {
  const double distance = local.norm();
  const Vec3 normal = distance > 0.0 ? Vec3(local / distance) : Vec3(Vec3::UnitZ());
  return {radius - distance, normal};
}

ColliderSurface SphereShape::surface() const {
  ColliderSurface surface;
  surface.addTurned(kDrawnAround / 2, [&](double angle, double share) {
    const double polar = std::numbers::pi * share;
    const Vec3 normal(std::sin(polar) * std::cos(angle), std::sin(polar) * std::sin(angle), -std::cos(polar));
    surface.addPoint(radius * normal, normal);
  });
  return surface;
}

ColliderOutline SphereShape::outline() const {
  const Vec3 x = radius * Vec3::UnitX();
  const Vec3 y = radius * Vec3::UnitY();
  const Vec3 z = radius * Vec3::UnitZ();
  ColliderOutline outline;
  addEllipse(Vec3::Zero(), x, y, outline);
  addEllipse(Vec3::Zero(), y, z, outline);
  addEllipse(Vec3::Zero(), z, x, outline);
  return outline;
}

}  // namespace sim
