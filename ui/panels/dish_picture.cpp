#include "ui/panels/dish_picture.h"

#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <cmath>

#include "modeling/shapes/measured_chain.h"
#include "ui/theme/theme.h"

namespace ui {
namespace {

/// How far an upright circle is seen to lie down.
constexpr double kTilt = 0.16;

struct Outline {
  std::vector<modeling::Vec2> points;  ///< from the base to the rim
  double radius = 0.0;
  double top = 0.0;
};

Outline outlineOf(const modeling::RevolutionShape& shape) {
  Outline outline;
  constexpr int kSteps = 16;
  for (const auto& segment : shape.outside) {
    for (int i = 0; i <= kSteps; ++i) {
      const modeling::Vec2 point = modeling::evaluate(segment, static_cast<double>(i) / kSteps);
      outline.points.push_back(point);
      outline.radius = std::max(outline.radius, point.x());
      outline.top = std::max(outline.top, point.y());
    }
  }
  return outline;
}

/// Draws at the size and resolution that is asked for, in the present colours.
class DishIconEngine : public QIconEngine {
 public:
  explicit DishIconEngine(ProfilePreset preset) : preset_(preset) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const Colours& colours = Theme::instance().colours();
    QColor line = mode == QIcon::Selected ? colours.accentText : colours.text;
    if (mode == QIcon::Disabled) line = colours.dimText;
    QColor fill = line;
    fill.setAlphaF(0.12F);
    painter->save();
    const double width = 1.8 * rect.width() / 24.0;
    paintDish(*painter, shapeOf(preset_), QRectF(rect).adjusted(width, width, -width, -width), line, fill);
    painter->restore();
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap pixels(size);
    pixels.fill(Qt::transparent);
    QPainter painter(&pixels);
    paint(&painter, QRect(QPoint(), size), mode, state);
    return pixels;
  }
  QIconEngine* clone() const override { return new DishIconEngine(preset_); }

 private:
  ProfilePreset preset_;
};

}  // namespace

void paintDish(QPainter& painter, const modeling::RevolutionShape& shape, const QRectF& within,
               const QColor& line, const QColor& fill) {
  const Outline outline = outlineOf(shape);
  if (outline.points.empty() || !(outline.radius > 0.0)) return;
  const double rim = outline.points.back().x();
  const double above = kTilt * rim;
  const double scale =
      std::min(within.width() / (2.0 * outline.radius), within.height() / (outline.top + above));
  const double left = within.center().x();
  const double bottom = within.bottom() - 0.5 * (within.height() - scale * (outline.top + above));
  const auto at = [&](double r, double z) { return QPointF(left + scale * r, bottom - scale * z); };
  QPainterPath body(at(-outline.points.front().x(), outline.points.front().y()));
  for (const modeling::Vec2& point : outline.points) body.lineTo(at(point.x(), point.y()));
  for (auto point = outline.points.rbegin(); point != outline.points.rend(); ++point)
    body.lineTo(at(-point->x(), point->y()));
  body.closeSubpath();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(
      QPen(line, std::clamp(within.width() / 14.0, 1.0, 2.2), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  const QRectF mouth(at(-rim, outline.top + above), at(rim, outline.points.back().y() - above));
  QPainterPath opening;
  opening.addEllipse(mouth);
  painter.setBrush(fill);
  painter.drawPath(body.united(opening));
  painter.setBrush(Qt::NoBrush);
  painter.drawPath(opening);
}

QIcon dishIcon(ProfilePreset preset) {
  return QIcon(new DishIconEngine(preset));
}

}  // namespace ui
