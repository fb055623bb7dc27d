#include "ui/viewport/view_camera.h"

#include <QRectF>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ui {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
/// Straight up and down would leave open which way is up in the picture.
constexpr double kHighest = std::numbers::pi / 2.0 - 1e-4;

QVector3D single(const sim::Vec3& vector) {
  return {static_cast<float>(vector.x()), static_cast<float>(vector.y()), static_cast<float>(vector.z())};
}

}  // namespace

sim::Vec3 ViewCamera::forward() const {
  return -sim::Vec3(std::cos(elevation_) * std::cos(azimuth_), std::cos(elevation_) * std::sin(azimuth_),
                    std::sin(elevation_));
}

sim::Vec3 ViewCamera::right() const {
  return {-std::sin(azimuth_), std::cos(azimuth_), 0.0};
}

sim::Vec3 ViewCamera::up() const {
  return right().cross(forward());
}

void ViewCamera::look(const sim::Vec3& target, double distance, double azimuth, double elevation) {
  target_ = target;
  distance_ = std::clamp(distance, 1e-3, 1e7);
  azimuth_ = std::remainder(azimuth, 2.0 * std::numbers::pi);
  elevation_ = std::clamp(elevation, -kHighest, kHighest);
}

void ViewCamera::lookAlong(Axis axis) {
  constexpr double kQuarter = std::numbers::pi / 2.0;
  switch (axis) {
    case Axis::right:
      return look(target_, distance_, 0.0, 0.0);
    case Axis::left:
      return look(target_, distance_, 2.0 * kQuarter, 0.0);
    case Axis::front:
      return look(target_, distance_, -kQuarter, 0.0);
    case Axis::back:
      return look(target_, distance_, kQuarter, 0.0);
    case Axis::top:
      return look(target_, distance_, -kQuarter, kHighest);
    case Axis::bottom:
      return look(target_, distance_, -kQuarter, -kHighest);
  }
}

void ViewCamera::orbit(double azimuthChange, double elevationChange) {
  look(target_, distance_, azimuth_ + azimuthChange, elevation_ + elevationChange);
}

double ViewCamera::pixelSize(const sim::Vec3& at, const QSizeF& size) const {
  const double depth = orthographic_ ? distance_ : std::max((at - eye()).dot(forward()), 1e-6);
  return 2.0 * depth * std::tan(0.5 * fieldOfView_) / std::max(size.height(), 1.0);
}

void ViewCamera::pan(const QPointF& pixels, const QSizeF& size) {
  const double scale = pixelSize(target_, size);
  target_ += scale * (-pixels.x() * right() + pixels.y() * up());
}

void ViewCamera::zoom(double factor, const QPointF& at, const QSizeF& size) {
  const double scale = pixelSize(target_, size);
  const QPointF fromMiddle = at - QPointF(0.5 * size.width(), 0.5 * size.height());
  const sim::Vec3 offset = scale * (fromMiddle.x() * right() - fromMiddle.y() * up());
  target_ += (1.0 - factor) * offset;
  look(target_, factor * distance_, azimuth_, elevation_);
}

void ViewCamera::frame(const Eigen::AlignedBox3d& box, const QSizeF& size) {
  if (box.isEmpty()) return;
  const double radius = std::max(0.5 * box.diagonal().norm(), 1e-3);
  const double aspect = size.width() / std::max(size.height(), 1.0);
  const double half = std::atan(std::tan(0.5 * fieldOfView_) * std::min(aspect, 1.0));
  look(box.center(), 1.05 * radius / std::sin(half), azimuth_, elevation_);
}

bool ViewCamera::sees(const Eigen::AlignedBox3d& box, const QSizeF& size) const {
  if (box.isEmpty()) return true;
  const QRectF picture(QPointF(), size);
  for (int corner = 0; corner < 8; ++corner) {
    const auto at = project(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)), size);
    if (!at || !picture.contains(*at)) return false;
  }
  return true;
}

void ViewCamera::set(const modeling::Camera& camera) {
  const sim::Vec3 back = camera.position - camera.target;
  fieldOfView_ = camera.fieldOfView * kRadiansPerDegree;
  look(camera.target, back.norm(), std::atan2(back.y(), back.x()),
       std::atan2(back.z(), std::hypot(back.x(), back.y())));
}

modeling::Camera ViewCamera::asScene() const {
  modeling::Camera camera;
  camera.position = eye();
  camera.target = target_;
  camera.fieldOfView = fieldOfView_ / kRadiansPerDegree;
  return camera;
}

QMatrix4x4 ViewCamera::viewFromWorld() const {
  QMatrix4x4 matrix;
  matrix.lookAt(single(eye()), single(target_), single(up()));
  return matrix;
}

QMatrix4x4 ViewCamera::clipFromView(const QSizeF& size, const Eigen::AlignedBox3d& all) const {
  const auto aspect = static_cast<float>(size.width() / std::max(size.height(), 1.0));
  const double reach = all.isEmpty() ? distance_ : all.diagonal().norm();
  const double depth = all.isEmpty() ? distance_ : (all.center() - eye()).dot(forward());
  QMatrix4x4 matrix;
  if (orthographic_) {
    const auto half = static_cast<float>(distance_ * std::tan(0.5 * fieldOfView_));
    matrix.ortho(-aspect * half, aspect * half, -half, half, static_cast<float>(depth - reach),
                 static_cast<float>(depth + reach));
    return matrix;
  }
  const double farPlane = std::max(depth + reach, 2.0 * distance_);
  const double nearPlane = std::max(depth - reach, 1e-3 * std::min(farPlane, 10.0 * distance_));
  matrix.perspective(static_cast<float>(fieldOfView_ / kRadiansPerDegree), aspect,
                     static_cast<float>(nearPlane), static_cast<float>(farPlane));
  return matrix;
}

std::optional<QPointF> ViewCamera::project(const sim::Vec3& point, const QSizeF& size) const {
  const sim::Vec3 offset = point - eye();
  if (!orthographic_ && offset.dot(forward()) < 1e-6) return std::nullopt;
  const double scale = 1.0 / pixelSize(point, size);
  return QPointF(0.5 * size.width() + scale * offset.dot(right()),
                 0.5 * size.height() - scale * offset.dot(up()));
}

Ray ViewCamera::rayThrough(const QPointF& pixel, const QSizeF& size) const {
  const double scale = pixelSize(target_, size);
  const QPointF fromMiddle = pixel - QPointF(0.5 * size.width(), 0.5 * size.height());
  const sim::Vec3 across = scale * (fromMiddle.x() * right() - fromMiddle.y() * up());
  if (orthographic_) return {eye() + across, forward()};
  return {eye(), (target_ + across - eye()).normalized()};
}

}  // namespace ui
