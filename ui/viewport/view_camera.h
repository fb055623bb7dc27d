#pragma once

#include <QMatrix4x4>
#include <QPointF>
#include <QSizeF>

#include <Eigen/Geometry>

#include "modeling/scene/picture_style.h"

namespace ui {

/// A line of sight: from the eye through a point of the picture.
struct Ray {
  sim::Vec3 origin = sim::Vec3::Zero();
  sim::Vec3 direction = sim::Vec3::UnitX();  ///< unit
};

/// The eye of the viewport: turns about a target, z stays upright. Lengths in cm, picture points in logical
/// pixels from the upper left corner.
class ViewCamera {
 public:
  enum class Axis { right, left, front, back, top, bottom };

  const sim::Vec3& target() const { return target_; }
  double distance() const { return distance_; }
  /// Radians; the direction from the target to the eye.
  double azimuth() const { return azimuth_; }
  double elevation() const { return elevation_; }
  bool isOrthographic() const { return orthographic_; }
  sim::Vec3 eye() const { return target_ - distance_ * forward(); }
  /// Unit, in the world: where the eye looks, and what is right and up in the picture.
  sim::Vec3 forward() const;
  sim::Vec3 right() const;
  sim::Vec3 up() const;

  void setOrthographic(bool orthographic) { orthographic_ = orthographic; }
  void look(const sim::Vec3& target, double distance, double azimuth, double elevation);
  void lookAlong(Axis axis);
  void orbit(double azimuthChange, double elevationChange);
  /// So that what is at the target moves by so many pixels.
  void pan(const QPointF& pixels, const QSizeF& size);
  /// Nearer by a factor below 1; the point under the cursor stays where it is.
  void zoom(double factor, const QPointF& at, const QSizeF& size);
  void frame(const Eigen::AlignedBox3d& box, const QSizeF& size);

  /// All corners of the box are in the picture.
  bool sees(const Eigen::AlignedBox3d& box, const QSizeF& size) const;

  void set(const modeling::Camera& camera);
  modeling::Camera asScene() const;

  QMatrix4x4 viewFromWorld() const;
  /// Near and far planes around a box of all there is.
  QMatrix4x4 clipFromView(const QSizeF& size, const Eigen::AlignedBox3d& all) const;
  /// Where a point of the world is in the picture; nothing where it is behind the eye.
  std::optional<QPointF> project(const sim::Vec3& point, const QSizeF& size) const;
  Ray rayThrough(const QPointF& pixel, const QSizeF& size) const;
  /// cm a logical pixel at that depth.
  double pixelSize(const sim::Vec3& at, const QSizeF& size) const;

 private:
  sim::Vec3 target_ = sim::Vec3::Zero();
  double distance_ = 60.0;
  double azimuth_ = -1.05;
  double elevation_ = 0.35;
  double fieldOfView_ = 0.6;  ///< radians, vertical
  bool orthographic_ = false;
};

}  // namespace ui
