#include "ui/picture/camera.h"

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

/// Share of the picture's half size left empty around the subject.
constexpr double kMargin = 0.16;

}  // namespace

Camera frameBox(const Box& box, double aspect, const ViewDirection& direction) {
  using sim::Vec3;
  const double level = std::cos(direction.elevation);
  const Vec3 towardsCamera(level * std::cos(direction.azimuth), level * std::sin(direction.azimuth),
                           std::sin(direction.elevation));
  const Vec3 right = Vec3::UnitZ().cross(towardsCamera).normalized();
  const Vec3 up = towardsCamera.cross(right);
  const double upTangent = std::tan(direction.fieldOfView / 2.0) * (1.0 - kMargin);
  const double rightTangent = upTangent * aspect;

  double distance = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 offset = box.corner(static_cast<Box::CornerType>(corner)) - box.center();
    const double depth = offset.dot(towardsCamera);
    distance = std::max(distance, std::abs(offset.dot(right)) / rightTangent + depth);
    distance = std::max(distance, std::abs(offset.dot(up)) / upTangent + depth);
  }
  Camera camera;
  camera.target = box.center();
  camera.position = box.center() + std::max(distance, 1e-3) * towardsCamera;
  camera.verticalFieldOfView = direction.fieldOfView;
  return camera;
}

}  // namespace ui
