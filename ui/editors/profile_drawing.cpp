#include "ui/editors/profile_drawing.h"

#include <QCoreApplication>
#include <QPainterPath>
#include <cmath>

#include "ui/theme/theme.h"

namespace ui {
namespace {

using modeling::Vec2;

constexpr double kStrip = 20.0;  ///< pixels below and left of the drawing, where the numbers stand

QColor faded(QColor colour, double alpha) {
  colour.setAlphaF(static_cast<float>(alpha));
  return colour;
}

void append(QPainterPath& path, const ProfileView& view, const modeling::ProfileChain& chain, bool begin) {
  const QPointF first = view.toPixel(chain.front()[0]);
  if (begin) {
    path.moveTo(first);
  } else {
    path.lineTo(first);
  }
  for (const auto& segment : chain)
    path.cubicTo(view.toPixel(segment[1]), view.toPixel(segment[2]), view.toPixel(segment[3]));
}

modeling::ProfileChain reversed(const modeling::ProfileChain& chain) {
  modeling::ProfileChain back;
  for (auto segment = chain.rbegin(); segment != chain.rend(); ++segment)
    back.push_back({(*segment)[3], (*segment)[2], (*segment)[1], (*segment)[0]});
  return back;
}

}  // namespace

QColor colourOf(ProfileSide side) {
  const Colours& colours = Theme::instance().colours();
  return side == ProfileSide::outside ? colours.accent : colours.warning;
}

void ProfileDrawing::gridLines(double step, const QColor& colour) {
  painter_.setPen(QPen(colour, 1.0));
  const Vec2 low = view_.toPlane({0.0, size_.height()});
  const Vec2 high = view_.toPlane({size_.width(), 0.0});
  for (double r = std::ceil(low.x() / step) * step; r <= high.x(); r += step) {
    const double x = std::floor(view_.toPixel({r, 0.0}).x()) + 0.5;
    painter_.drawLine(QPointF(x, 0.0), QPointF(x, size_.height()));
  }
  for (double z = std::ceil(low.y() / step) * step; z <= high.y(); z += step) {
    const double y = std::floor(view_.toPixel({0.0, z}).y()) + 0.5;
    painter_.drawLine(QPointF(0.0, y), QPointF(size_.width(), y));
  }
}

void ProfileDrawing::numbers(double step) {
  const Colours& colours = Theme::instance().colours();
  painter_.setFont(Theme::numberFont(-1.5));
  const QColor strip = faded(colours.field, 0.82);
  painter_.fillRect(QRectF(0.0, size_.height() - kStrip, size_.width(), kStrip), strip);
  painter_.setPen(colours.dimText);
  const Vec2 low = view_.toPlane({0.0, size_.height()});
  const Vec2 high = view_.toPlane({size_.width(), 0.0});
  const auto text = [&](double value) { return QString::number(std::abs(value) < 1e-9 ? 0.0 : value); };
  for (double r = std::ceil(low.x() / step) * step; r <= high.x(); r += step) {
    const double x = view_.toPixel({r, 0.0}).x();
    if (x < 44.0 || x > size_.width() - 40.0) continue;
    painter_.drawText(QRectF(x - 30.0, size_.height() - kStrip, 60.0, kStrip), Qt::AlignCenter,
                      text(std::abs(r)));
  }
  for (double z = std::ceil(low.y() / step) * step; z <= high.y(); z += step) {
    const double y = view_.toPixel({0.0, z}).y();
    if (y < 10.0 || y > size_.height() - kStrip - 8.0) continue;
    painter_.drawText(QRectF(0.0, y - 8.0, 34.0, 16.0), Qt::AlignRight | Qt::AlignVCenter, text(z));
  }
  painter_.drawText(QRectF(size_.width() - 40.0, size_.height() - kStrip, 34.0, kStrip),
                    Qt::AlignRight | Qt::AlignVCenter, QCoreApplication::translate("profile", "cm"));
}

void ProfileDrawing::grid() {
  const Colours& colours = Theme::instance().colours();
  painter_.fillRect(QRectF(QPointF(), size_), colours.field);
  painter_.setRenderHint(QPainter::Antialiasing, false);
  gridLines(view_.fineGrid(), faded(colours.grid, 0.28));
  gridLines(view_.coarseGrid(), faded(colours.grid, 0.62));
  const double x = std::floor(view_.toPixel({0.0, 0.0}).x()) + 0.5;
  painter_.setPen(QPen(colours.axisZ, 1.4, Qt::DashDotLine));
  painter_.drawLine(QPointF(x, 0.0), QPointF(x, size_.height()));
  painter_.setRenderHint(QPainter::Antialiasing, true);
  numbers(view_.coarseGrid());
}

void ProfileDrawing::wall(const ProfileModel& model) {
  const Colours& colours = Theme::instance().colours();
  QPainterPath body;
  append(body, view_, model.shape().outside, true);
  append(body, view_, reversed(model.shape().inside), false);
  body.closeSubpath();
  QPainterPath outside;
  append(outside, view_, model.shape().outside, true);
  QPainterPath inside;
  append(inside, view_, model.shape().inside, true);

  const double axis = view_.toPixel({0.0, 0.0}).x();
  const QTransform mirror(-1.0, 0.0, 0.0, 1.0, 2.0 * axis, 0.0);
  painter_.setPen(QPen(faded(colours.dimText, 0.55), 1.0, Qt::DashLine));
  painter_.setBrush(faded(colours.dimText, 0.10));
  painter_.drawPath(mirror.map(body));

  painter_.setPen(Qt::NoPen);
  painter_.setBrush(faded(colours.text, 0.16));
  painter_.drawPath(body);
  painter_.setBrush(Qt::NoBrush);
  painter_.setPen(QPen(faded(colours.dimText, 0.9), 1.2));
  const auto rim = [&](const Vec2& a, const Vec2& b) {
    if (a.x() > 1e-9 && b.x() > 1e-9) painter_.drawLine(view_.toPixel(a), view_.toPixel(b));
  };
  rim(model.shape().outside.front()[0], model.shape().inside.front()[0]);
  rim(model.shape().outside.back()[3], model.shape().inside.back()[3]);
  painter_.setPen(QPen(colourOf(ProfileSide::inside), 2.0));
  painter_.drawPath(inside);
  painter_.setPen(QPen(colourOf(ProfileSide::outside), 2.0));
  painter_.drawPath(outside);
}

void ProfileDrawing::handle(const ProfileModel& model, const ControlId& handle, bool selected, bool hovered) {
  const Colours& colours = Theme::instance().colours();
  const QPointF at = view_.toPixel(model.position(handle));
  const QColor colour = selected ? colours.text : colours.dimText;
  painter_.setPen(QPen(faded(colour, 0.8), 1.0));
  painter_.drawLine(view_.toPixel(model.position(handle.point())), at);
  painter_.setPen(QPen(colours.field, 1.0));
  painter_.setBrush(hovered ? colourOf(handle.side) : colour);
  const double radius = hovered || selected ? 4.5 : 3.5;
  painter_.drawEllipse(at, radius, radius);
}

void ProfileDrawing::point(const ProfileModel& model, const ControlId& point, bool selected, bool hovered) {
  const Colours& colours = Theme::instance().colours();
  const QPointF at = view_.toPixel(model.position(point));
  const double radius = hovered ? 5.5 : 4.5;
  painter_.setPen(QPen(selected ? colours.text : colourOf(point.side), 1.8));
  painter_.setBrush(selected ? colourOf(point.side) : hovered ? colours.raised : colours.field);
  if (model.isSmooth(point)) {
    painter_.drawEllipse(at, radius, radius);
  } else {
    painter_.drawRect(QRectF(at.x() - radius, at.y() - radius, 2.0 * radius, 2.0 * radius));
  }
}

void ProfileDrawing::insertion(const Vec2& at) {
  const Colours& colours = Theme::instance().colours();
  const QPointF pixel = view_.toPixel(at);
  painter_.setPen(QPen(colours.good, 2.0));
  painter_.setBrush(colours.field);
  painter_.drawEllipse(pixel, 6.0, 6.0);
  painter_.drawLine(pixel - QPointF(3.0, 0.0), pixel + QPointF(3.0, 0.0));
  painter_.drawLine(pixel - QPointF(0.0, 3.0), pixel + QPointF(0.0, 3.0));
}

void ProfileDrawing::snap(const Vec2& at) {
  const QPointF pixel = view_.toPixel(at);
  painter_.setPen(QPen(Theme::instance().colours().good, 1.4));
  painter_.setBrush(Qt::NoBrush);
  painter_.drawEllipse(pixel, 9.0, 9.0);
}

void ProfileDrawing::selectionBox(const QRectF& box) {
  const QColor accent = Theme::instance().colours().accent;
  painter_.setPen(QPen(accent, 1.0, Qt::DashLine));
  painter_.setBrush(faded(accent, 0.10));
  painter_.drawRect(box);
}

void ProfileDrawing::legend() {
  painter_.setFont(QFont());
  const auto entry = [&](double y, ProfileSide side, const QString& name) {
    const double right = size_.width() - 12.0;
    painter_.setPen(QPen(colourOf(side), 2.0));
    painter_.drawLine(QPointF(right - 18.0, y), QPointF(right, y));
    painter_.setPen(Theme::instance().colours().dimText);
    painter_.drawText(QRectF(right - 128.0, y - 9.0, 102.0, 18.0), Qt::AlignRight | Qt::AlignVCenter, name);
  };
  entry(16.0, ProfileSide::outside, QCoreApplication::translate("profile", "Outside"));
  entry(34.0, ProfileSide::inside, QCoreApplication::translate("profile", "Inside"));
}

}  // namespace ui
