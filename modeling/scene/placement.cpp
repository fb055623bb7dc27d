#include "modeling/scene/placement.h"

#include <numbers>

namespace modeling {

Eigen::Quaterniond Rotation::quaternion() const {
  if (const auto* written = std::get_if<Eigen::Vector4d>(&value)) {
    const Eigen::Vector4d unit = written->stableNormalized();
    return {unit[0], unit[1], unit[2], unit[3]};
  }
  const Vec3 radians = std::get<Vec3>(value) * (std::numbers::pi / 180.0);
  using Turn = Eigen::AngleAxisd;
  return Turn(radians.z(), Vec3::UnitZ()) * Turn(radians.y(), Vec3::UnitY()) *
         Turn(radians.x(), Vec3::UnitX());
}

Eigen::Affine3d Placement::worldFromPart() const {
  return Eigen::Translation3d(position) * rotation.quaternion() * Eigen::Scaling(scale.factors);
}

}  // namespace modeling
