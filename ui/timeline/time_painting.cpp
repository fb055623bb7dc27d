#include "ui/timeline/time_painting.h"

#include <cmath>

namespace ui {
namespace {

double snapped(const QPainter& painter, double at) {
  const double ratio = painter.device()->devicePixelRatioF();
  return std::round(at * ratio) / ratio;
}

}  // namespace

void verticalLine(QPainter& painter, double x, double top, double bottom, const QColor& colour,
                  double width) {
  painter.fillRect(QRectF(snapped(painter, x - 0.5 * width), top, width, bottom - top), colour);
}

void horizontalLine(QPainter& painter, double left, double right, double y, const QColor& colour) {
  painter.fillRect(QRectF(left, snapped(painter, y - 0.5), right - left, 1.0), colour);
}

QColor mixed(const QColor& from, const QColor& to, double share) {
  const auto mix = [share](int a, int b) { return static_cast<int>(std::lround(a + share * (b - a))); };
  return QColor(mix(from.red(), to.red()), mix(from.green(), to.green()), mix(from.blue(), to.blue()));
}

}  // namespace ui
