#pragma once

#include <QSizeF>

#include "ui/viewport/overlay.h"
#include "ui/viewport/view_camera.h"

class QPainter;

namespace ui {

/// Draws an overlay with a painter over the picture a camera has of the world.
class PaintedOverlay : public Overlay {
 public:
  PaintedOverlay(QPainter& painter, const ViewCamera& camera, const QSizeF& size)
      : painter_(painter), camera_(camera), size_(size) {}

  void line(const sim::Vec3& from, const sim::Vec3& to, const QColor& colour, double width = 1.5) override;
  void point(const sim::Vec3& at, const QColor& colour, double diameter = 8.0) override;
  void text(const sim::Vec3& at, const QString& text, const QColor& colour) override;

 private:
  QPainter& painter_;
  const ViewCamera& camera_;
  QSizeF size_;
};

}  // namespace ui
