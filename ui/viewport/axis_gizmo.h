#pragma once

#include <QPointF>
#include <QSizeF>
#include <optional>

#include "ui/viewport/view_camera.h"

class QPainter;

namespace ui {

/// The little axes in the lower left corner: show how the view is turned, orbit when dragged, and look along
/// an axis whose end is clicked.
class AxisGizmo {
 public:
  bool contains(const QPointF& at, const QSizeF& size) const;
  /// The axis whose end is there: from where one looks.
  std::optional<ViewCamera::Axis> axisAt(const QPointF& at, const ViewCamera& camera,
                                         const QSizeF& size) const;
  void paint(QPainter& painter, const ViewCamera& camera, const QSizeF& size,
             const std::optional<QPointF>& pointer) const;

 private:
  static QPointF middle(const QSizeF& size);
};

}  // namespace ui
