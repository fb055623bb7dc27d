#include "sim/collider/collider.h"

namespace sim {
namespace {

/// Share of the depth at which the way out may lead to another side. With the hops in which ways are looked
/// at (collider_stop.cpp) no node gets to nine tenths of it.
constexpr double kDeepestShare = 0.8;

}  // namespace

Intrusion intrusion(const Collider& collider, const Vec3& point, std::uint32_t near) {
  const Vec3 local = collider.rotation.conjugate() * (point - collider.position);
  Intrusion inside =
      std::visit([&](const auto& shape) { return shape.intrusion(local, near); }, collider.shape);
  inside.normal = collider.rotation * inside.normal;
  return inside;
}

double deepest(const Collider& collider) {
  return kDeepestShare * std::visit([](const auto& shape) { return shape.middleDepth(); }, collider.shape);
}

double reachOf(const Collider& collider) {
  return std::visit([](const auto& shape) { return shape.reach(); }, collider.shape);
}

std::string_view kindName(const Collider& collider) {
  return std::visit([](const auto& shape) { return std::string_view(shape.kName); }, collider.shape);
}

ColliderSurface surfaceOf(const Collider& collider) {
  return std::visit([](const auto& shape) { return shape.surface(); }, collider.shape);
}

ColliderOutline outlineOf(const Collider& collider) {
  ColliderOutline outline = std::visit([](const auto& shape) { return shape.outline(); }, collider.shape);
  for (auto& line : outline) {
    for (Vec3& point : line) point = collider.position + collider.rotation * point;
  }
  return outline;
}

Eigen::AlignedBox3d boxOf(const Collider& collider) {
  Eigen::AlignedBox3d box;
  if (collider.isFloor()) return box;
  for (const auto& line : outlineOf(collider)) {
    for (const Vec3& point : line) box.extend(point);
  }
  return box;
}

}  // namespace sim
