#pragma once

#include <QPointF>
#include <QSizeF>

#include <Eigen/Geometry>

#include "modeling/shapes/bezier.h"

namespace ui {

/// Which part of the half-plane (r, z) a picture shows: r to the right, z up. Picture points in logical
/// pixels from the upper left corner, lengths in cm.
class ProfileView {
 public:
  QPointF toPixel(const modeling::Vec2& point) const {
    return {axis_.x() + scale_ * point.x(), axis_.y() - scale_ * point.y()};
  }
  modeling::Vec2 toPlane(const QPointF& pixel) const {
    return {(pixel.x() - axis_.x()) / scale_, (axis_.y() - pixel.y()) / scale_};
  }
  double scale() const { return scale_; }  ///< pixels a cm

  void pan(const QPointF& by) { axis_ += by; }
  /// Nearer by a factor above 1; what is at `at` stays there.
  void zoom(double factor, const QPointF& at);
  /// The box in the right and larger part of the picture, so that some of the mirror image is seen.
  void frame(const Eigen::AlignedBox2d& box, const QSizeF& size);

  /// cm between lines of the grid: 1, 2 or 5 times a power of ten.
  double coarseGrid() const;
  double fineGrid() const;

 private:
  QPointF axis_{120.0, 240.0};  ///< where r = 0, z = 0 is
  double scale_ = 30.0;
};

}  // namespace ui
