#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/picture/camera.h"
#include "ui/picture/linear.h"

namespace ui {

/// Rays through pixels, in coordinates relative to the middle of the subject.
class Lens {
 public:
  struct Ray {
    Vec3f origin;
    Vec3f direction;  ///< unit
  };

  Lens(const Camera& camera, const sim::Vec3& middle, int width, int height)
      : eye_((camera.position - middle).cast<float>()),
        radius_(static_cast<float>(camera.aperture / 2.0)),
        middleX_(0.5F * static_cast<float>(width)),
        middleY_(0.5F * static_cast<float>(height)) {
    sim::Vec3 ahead = camera.target - camera.position;
    const double distance = ahead.norm();
    ahead = distance > 0.0 ? sim::Vec3(ahead / distance) : -sim::Vec3::UnitZ();
    const sim::Vec3 level = ahead.cross(sim::Vec3::UnitZ());
    const sim::Vec3 right = level.norm() > 1e-9 ? sim::Vec3(level.normalized()) : sim::Vec3::UnitX();
    const double pixel = 2.0 * std::tan(camera.verticalFieldOfView / 2.0) / height;
    focus_ = static_cast<float>(camera.focus > 0.0 ? camera.focus : std::max(distance, 1e-3));
    forward_ = ahead.cast<float>();
    right_ = right.cast<float>();
    down_ = ahead.cross(right).cast<float>();
    pixel_ = static_cast<float>(pixel);
  }

  /// x, y in pixels from the upper left; `random` chooses a point of the lens.
  Ray through(float x, float y, const std::array<float, 2>& random) const {
    const Vec3f ahead = forward_ + pixel_ * ((x - middleX_) * right_ + (y - middleY_) * down_);
    if (radius_ <= 0.0F) return {eye_, ahead.normalized()};
    const float radius = radius_ * std::sqrt(random[0]);
    const float angle = 2.0F * std::numbers::pi_v<float> * random[1];
    const Vec3f aside = radius * (std::cos(angle) * right_ + std::sin(angle) * down_);
    return {eye_ + aside, (focus_ * ahead - aside).normalized()};
  }

 private:
  Vec3f eye_;
  Vec3f forward_;
  Vec3f right_;
  Vec3f down_;
  float pixel_ = 0.0F;
  float focus_ = 1.0F;
  float radius_;
  float middleX_;
  float middleY_;
};

}  // namespace ui
