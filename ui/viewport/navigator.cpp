#include "ui/viewport/navigator.h"

#include <QPointingDevice>
#include <QWheelEvent>
#include <cmath>

namespace ui {
namespace {

/// Radians a pixel: half a turn across a window of 800 pixels.
constexpr double kOrbit = 0.004 * 2.0;
/// Share of the distance a pixel.
constexpr double kDragZoom = 0.006;
/// A notch of a wheel (120) brings the eye nearer by an eighth.
constexpr double kWheelZoom = 0.0011;

}  // namespace

Navigator::Motion Navigator::motionOf(const PointerEvent& event) const {
  const bool shift = event.modifiers.testFlag(Qt::ShiftModifier);
  const bool control = event.modifiers.testFlag(Qt::ControlModifier);
  const bool alt = event.modifiers.testFlag(Qt::AltModifier);
  if (preset_ == NavigationPreset::maya) {
    if (!alt) return Motion::none;
    if (event.buttons.testFlag(Qt::LeftButton)) return Motion::orbit;
    if (event.buttons.testFlag(Qt::MiddleButton)) return Motion::pan;
    return event.buttons.testFlag(Qt::RightButton) ? Motion::zoom : Motion::none;
  }
  if (!event.buttons.testFlag(Qt::MiddleButton)) return Motion::none;
  if (shift) return Motion::pan;
  return control ? Motion::zoom : Motion::orbit;
}

bool Navigator::press(const PointerEvent& event) {
  motion_ = motionOf(event);
  last_ = event.position;
  start_ = event.position;
  return isMoving();
}

void Navigator::move(const PointerEvent& event, const QSizeF& size) {
  const QPointF moved = event.position - last_;
  last_ = event.position;
  if (motion_ == Motion::orbit) orbitBy(moved);
  if (motion_ == Motion::pan) camera_.pan(moved, size);
  if (motion_ == Motion::zoom) camera_.zoom(std::exp(kDragZoom * (moved.y() - moved.x())), start_, size);
}

void Navigator::orbitBy(const QPointF& pixels) {
  camera_.orbit(-kOrbit * pixels.x(), kOrbit * pixels.y());
}

void Navigator::wheel(const QWheelEvent& event, const QSizeF& size) {
  const bool fingers = event.pointingDevice()->type() == QInputDevice::DeviceType::TouchPad ||
                       event.phase() != Qt::NoScrollPhase;
  if (!fingers) {
    // Alt turns a wheel sideways on some systems.
    const int turned = event.angleDelta().y() != 0 ? event.angleDelta().y() : event.angleDelta().x();
    camera_.zoom(std::exp(-kWheelZoom * turned), event.position(), size);
    return;
  }
  const QPointF moved =
      event.pixelDelta().isNull() ? QPointF(event.angleDelta()) / 8.0 : QPointF(event.pixelDelta());
  if (event.modifiers().testFlag(Qt::ShiftModifier)) {
    camera_.pan(moved, size);
  } else if (event.modifiers().testFlag(Qt::ControlModifier)) {
    camera_.zoom(std::exp(-kDragZoom * moved.y()), event.position(), size);
  } else {
    orbitBy(moved);
  }
}

void Navigator::pinch(double change, const QPointF& at, const QSizeF& size) {
  camera_.zoom(1.0 / (1.0 + std::max(change, -0.9)), at, size);
}

}  // namespace ui
