#pragma once

#include <array>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace ui {

/// Inside the tracer: single precision, relative to the middle of the subject.
using Vec3f = Eigen::Vector3f;

/// Linear light, sRGB primaries.
using Light = Eigen::Array3f;

inline float linearFromSrgb(double encoded) {
  return static_cast<float>(encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4));
}
inline Light linearFromSrgb(const std::array<double, 3>& colour) {
  return {linearFromSrgb(colour[0]), linearFromSrgb(colour[1]), linearFromSrgb(colour[2])};
}
inline float srgbFromLinear(float linear) {
  return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

/// Rotation that takes z to a unit vector.
inline Eigen::Matrix3f frameAround(const Vec3f& normal) {
  const float sign = std::copysign(1.0F, normal.z());
  const float a = -1.0F / (sign + normal.z());
  const float b = normal.x() * normal.y() * a;
  Eigen::Matrix3f frame;
  frame.col(0) = Vec3f(1.0F + sign * normal.x() * normal.x() * a, sign * b, -sign * normal.x());
  frame.col(1) = Vec3f(b, sign + normal.y() * normal.y() * a, -normal.y());
  frame.col(2) = normal;
  return frame;
}

inline float smoothStep(float from, float to, float value) {
  const float t = std::clamp((value - from) / (to - from), 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

}  // namespace ui
