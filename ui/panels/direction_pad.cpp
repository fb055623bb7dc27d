#include "ui/panels/direction_pad.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/theme/theme.h"

namespace ui {
namespace {

/// Of the radius: near the middle it is straight down.
constexpr double kSnap = 0.07;
constexpr double kKeyStep = 5.0 * std::numbers::pi / 180.0;

/// A place in the disc of radius 1: the angle from straight down grows evenly from the middle to the rim.
sim::Vec3 directionAt(double x, double y) {
  const double away = std::hypot(x, y);
  if (away < kSnap) return -sim::Vec3::UnitZ();
  const double tilt = std::min(away, 1.0) * 0.5 * std::numbers::pi;
  const double level = std::sin(tilt) / away;
  return {level * x, level * y, -std::cos(tilt)};
}

QPointF placeOf(const sim::Vec3& direction) {
  const double level = std::hypot(direction.x(), direction.y());
  if (level < 1e-9) return {0.0, 0.0};
  const double away = std::atan2(level, -direction.z()) / (0.5 * std::numbers::pi);
  return {away * direction.x() / level, away * direction.y() / level};
}

}  // namespace

DirectionPad::DirectionPad(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  setAccessibleName(tr("Direction of gravity"));
  setToolTip(
      tr("Direction of gravity, seen from above: the middle is straight down, the rim level.\n"
         "Drag the dot, or use the arrow keys; double-click: down"));
}

double DirectionPad::radius() const {
  return 0.5 * std::min(width(), height()) - 7.0;
}

void DirectionPad::setDirection(const sim::Vec3& direction) {
  if (!(direction.norm() > 0.0)) return;
  sim::Vec3 wanted = direction.normalized();
  if (wanted.z() > 1e-9) wanted = -wanted;
  if (wanted.isApprox(direction_, 1e-12)) return;
  direction_ = wanted;
  update();
}

void DirectionPad::choose(const sim::Vec3& direction) {
  setDirection(direction);
  emit changed(direction_);
}

void DirectionPad::pointAt(const QPointF& at) {
  const QPointF away = (at - QRectF(rect()).center()) / radius();
  choose(directionAt(away.x(), -away.y()));
}

void DirectionPad::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) pointAt(event->position());
}

void DirectionPad::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton)) pointAt(event->position());
}

void DirectionPad::mouseReleaseEvent(QMouseEvent*) {
  emit released();
}

void DirectionPad::mouseDoubleClickEvent(QMouseEvent*) {
  choose(-sim::Vec3::UnitZ());
}

/// Arrow keys are its own while it has the keyboard, not the timeline's.
bool DirectionPad::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down) {
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void DirectionPad::keyPressEvent(QKeyEvent* event) {
  QPointF place = placeOf(direction_);
  const double step = kKeyStep / (0.5 * std::numbers::pi);
  switch (event->key()) {
    case Qt::Key_Left:
      place.rx() -= step;
      break;
    case Qt::Key_Right:
      place.rx() += step;
      break;
    case Qt::Key_Up:
      place.ry() += step;
      break;
    case Qt::Key_Down:
      place.ry() -= step;
      break;
    default:
      QWidget::keyPressEvent(event);
      return;
  }
  choose(directionAt(place.x(), place.y()));
  emit released();
}

void DirectionPad::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Colours& colours = Theme::instance().colours();
  const QPointF middle = QRectF(rect()).center();
  painter.setPen(QPen(hasFocus() ? colours.accent : colours.line, 1.0));
  painter.setBrush(colours.field);
  painter.drawEllipse(middle, radius(), radius());
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colours.line, 1.0));
  painter.drawEllipse(middle, 0.5 * radius(), 0.5 * radius());
  painter.setPen(QPen(colours.axisX, 1.0));
  painter.drawLine(middle, middle + QPointF(radius(), 0));
  painter.setPen(QPen(colours.axisY, 1.0));
  painter.drawLine(middle, middle - QPointF(0, radius()));
  const QPointF place = placeOf(direction_);
  const QPointF dot = middle + radius() * QPointF(place.x(), -place.y());
  painter.setPen(QPen(colours.accent, 2.0));
  painter.drawLine(middle, dot);
  painter.setPen(QPen(colours.field, 1.5));
  painter.setBrush(colours.accent);
  painter.drawEllipse(dot, 5.5, 5.5);
}

}  // namespace ui
