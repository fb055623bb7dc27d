#pragma once

#include <QColor>
#include <QPointF>
#include <optional>

#include "ui/viewport/overlay.h"
#include "ui/viewport/transform.h"
#include "ui/viewport/view_camera.h"

namespace ui {

/// What a transform keeps to: an axis (0, 1, 2), the plane across it, or neither: then the plane of the
/// picture, or all axes alike.
struct TransformHold {
  enum class Kind : std::uint8_t { free, axis, plane };
  Kind kind = Kind::free;
  int axis = 0;

  bool operator==(const TransformHold&) const = default;
};

/// The handles of a transform: arrows and squares, rings, or rods. They keep their size in the picture.
class TransformGizmo {
 public:
  TransformGizmo(TransformMode mode, const sim::Vec3& pivot, const Eigen::Quaterniond& worldFromAxes)
      : mode_(mode), pivot_(pivot), worldFromAxes_(worldFromAxes) {}

  /// The handle under a point of the picture.
  std::optional<TransformHold> at(const QPointF& pixel, const ViewCamera& camera, const QSizeF& size) const;
  void draw(const ViewCamera& camera, const QSizeF& size, const std::optional<TransformHold>& lit,
            Overlay& overlay) const;

  sim::Vec3 direction(int axis) const { return worldFromAxes_ * sim::Vec3::Unit(axis); }
  const sim::Vec3& pivot() const { return pivot_; }
  static QColor colourOf(int axis);

 private:
  double length(const ViewCamera& camera, const QSizeF& size) const;
  std::array<sim::Vec3, 4> square(int axis, double length) const;
  sim::Vec3 onRing(int axis, double angle, double radius) const;
  double distanceToAxis(int axis, const QPointF& pixel, const ViewCamera& camera, const QSizeF& size) const;
  double distanceToRing(int axis, const QPointF& pixel, const ViewCamera& camera, const QSizeF& size) const;
  bool isInSquare(int axis, const QPointF& pixel, const ViewCamera& camera, const QSizeF& size) const;
  void drawMoveOrScale(double length, const std::optional<TransformHold>& lit, Overlay& overlay) const;
  void drawRotate(const ViewCamera& camera, double length, const std::optional<TransformHold>& lit,
                  Overlay& overlay) const;

  TransformMode mode_;
  sim::Vec3 pivot_;
  Eigen::Quaterniond worldFromAxes_;
};

}  // namespace ui
