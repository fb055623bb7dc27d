#include "ui/viewport/transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ui {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

/// Degrees to a ten-thousandth: what was turned by hand reads as if it had been typed.
double rounded(double value) {
  const double result = std::round(value * 1e4) / 1e4;
  return result == 0.0 ? 0.0 : result;
}

sim::Vec3 fixedAngles(const Eigen::Quaterniond& rotation) {
  const Eigen::Matrix3d m = rotation.toRotationMatrix();
  const double y = std::asin(std::clamp(-m(2, 0), -1.0, 1.0));
  double x = std::atan2(m(2, 1), m(2, 2));
  double z = std::atan2(m(1, 0), m(0, 0));
  // Straight up, x and z turn about one axis: all of it goes to x.
  if (std::abs(m(2, 0)) > 1.0 - 1e-12) {
    x = std::atan2(-m(1, 2), m(1, 1));
    z = 0.0;
  }
  return {rounded(kDegrees * x), rounded(kDegrees * y), rounded(kDegrees * z)};
}

sim::Vec3 placed(const sim::Vec3& position, const Eigen::Quaterniond& worldFromAxes, const Transform& by) {
  switch (by.mode) {
    case TransformMode::move:
      return position + by.offset;
    case TransformMode::rotate:
      return by.pivot + Eigen::AngleAxisd(by.angle, by.axis) * (position - by.pivot);
    case TransformMode::scale:
      break;
  }
  const sim::Vec3 own = worldFromAxes.conjugate() * (position - by.pivot);
  return by.pivot + worldFromAxes * own.cwiseProduct(by.factors);
}

}  // namespace

modeling::Rotation turned(const modeling::Rotation& rotation, const Eigen::Quaterniond& turn) {
  const Eigen::Quaterniond whole = (turn * rotation.quaternion()).normalized();
  modeling::Rotation result;
  if (std::holds_alternative<sim::Vec3>(rotation.value)) {
    result.value = fixedAngles(whole);
  } else {
    result.value = Eigen::Vector4d(whole.w(), whole.x(), whole.y(), whole.z());
  }
  return result;
}

TransformStart::TransformStart(const modeling::Scene& scene, const std::vector<Item>& items) {
  for (const Item& item : items) {
    if (item.kind == ItemKind::part && item.index < scene.parts.size()) {
      parts_.emplace_back(item.index, scene.parts[item.index].worldFromPart);
      partNames_.push_back(scene.parts[item.index].name);
      orientation_ = parts_.back().second.rotation.quaternion();
    } else if (item.kind == ItemKind::collider && item.index < scene.environment.colliders.size()) {
      colliders_.emplace_back(item.index, scene.environment.colliders[item.index]);
      orientation_ = colliders_.back().second.rotation.quaternion();
    }
  }
}

sim::Vec3 TransformStart::middle() const {
  sim::Vec3 sum = sim::Vec3::Zero();
  for (const auto& [index, placement] : parts_) sum += placement.position;
  for (const auto& [index, collider] : colliders_) sum += collider.position;
  return sum / static_cast<double>(std::max<std::size_t>(parts_.size() + colliders_.size(), 1));
}

void TransformStart::apply(const Transform& transform, modeling::Scene& scene) const {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(transform.angle, transform.axis));
  const bool turns = transform.mode == TransformMode::rotate && transform.angle != 0.0;
  for (const auto& [index, start] : parts_) {
    if (index >= scene.parts.size()) continue;
    modeling::Placement& placement = scene.parts[index].worldFromPart;
    placement = start;
    placement.position = placed(start.position, orientation_, transform);
    if (turns) placement.rotation = turned(start.rotation, turn);
    if (transform.mode == TransformMode::scale)
      placement.scale.factors = start.scale.factors.cwiseProduct(transform.factors);
  }
  for (const auto& [index, start] : colliders_) {
    if (index >= scene.environment.colliders.size()) continue;
    modeling::SceneCollider& collider = scene.environment.colliders[index];
    collider = start;
    collider.position = placed(start.position, orientation_, transform);
    if (turns) collider.rotation = turned(start.rotation, turn);
    if (transform.mode == TransformMode::scale) scale(collider.form, transform.factors);
  }
}

}  // namespace ui
