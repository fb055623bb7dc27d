#include "ui/viewport/painted_overlay.h"

#include <QPainter>

#include "ui/theme/theme.h"

namespace ui {

void PaintedOverlay::line(const sim::Vec3& from, const sim::Vec3& to, const QColor& colour, double width) {
  sim::Vec3 a = from;
  sim::Vec3 b = to;
  if (!camera_.isOrthographic()) {
    // What is behind the eye would come back upside down: cut where it passes the eye.
    const double nearest = 1e-3 * camera_.distance();
    const double depthA = (a - camera_.eye()).dot(camera_.forward());
    const double depthB = (b - camera_.eye()).dot(camera_.forward());
    if (depthA < nearest && depthB < nearest) return;
    if (depthA < nearest) a += (nearest - depthA) / (depthB - depthA) * (b - a);
    if (depthB < nearest) b += (nearest - depthB) / (depthA - depthB) * (a - b);
  }
  const auto start = camera_.project(a, size_);
  const auto end = camera_.project(b, size_);
  if (!start || !end) return;
  painter_.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
  painter_.drawLine(*start, *end);
}

void PaintedOverlay::point(const sim::Vec3& at, const QColor& colour, double diameter) {
  const auto middle = camera_.project(at, size_);
  if (!middle) return;
  painter_.setPen(QPen(Theme::instance().colours().window, 1.0));
  painter_.setBrush(colour);
  painter_.drawEllipse(*middle, 0.5 * diameter, 0.5 * diameter);
  painter_.setBrush(Qt::NoBrush);
}

void PaintedOverlay::text(const sim::Vec3& at, const QString& text, const QColor& colour) {
  const auto place = camera_.project(at, size_);
  if (!place) return;
  const QFontMetricsF metrics(painter_.font());
  QRectF box(*place + QPointF(10.0, -10.0),
             QSizeF(metrics.horizontalAdvance(text) + 12.0, metrics.height() + 4.0));
  QColor behind = Theme::instance().colours().window;
  behind.setAlphaF(0.82F);
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(behind);
  painter_.drawRoundedRect(box, 4.0, 4.0);
  painter_.setBrush(Qt::NoBrush);
  painter_.setPen(colour);
  painter_.drawText(box, Qt::AlignCenter, text);
}

}  // namespace ui
