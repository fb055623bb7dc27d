#include "ui/viewport/viewport_input.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <utility>

#include "ui/session/session.h"
#include "ui/viewport/camera_flight.h"
#include "ui/viewport/pointed_selection.h"
#include "ui/viewport/viewport.h"

namespace ui {
namespace {

/// A press that moves no farther, in logical pixels, is a click.
constexpr double kClickReach = 4.0;
/// The pointer has to rest so long before what is under it is looked for.
constexpr int kHoverMilliseconds = 50;
/// Logical pixels: the axes light up under a pointer that is so near to the corner.
constexpr double kAxesReach = 110.0;

PointerEvent pointerOf(const QMouseEvent& event) {
  return {event.position(), event.buttons(), event.modifiers()};
}

bool isNear(const QPointF& a, const QPointF& b) {
  return (a - b).manhattanLength() <= kClickReach;
}

}  // namespace

ViewportInput::ViewportInput(Viewport& viewport, ViewCamera& camera, CameraFlight& flight)
    : viewport_(viewport), camera_(camera), flight_(flight), navigator_(camera) {
  hovering_.setInterval(kHoverMilliseconds);
  hovering_.setSingleShot(true);
  connect(&hovering_, &QTimer::timeout, this, &ViewportInput::showHover);
}

QRectF ViewportInput::band() const {
  return hold_ == Hold::band && pointer_ ? QRectF(from_, *pointer_).normalized() : QRectF();
}

void ViewportInput::forgetToolPress() {
  if (hold_ == Hold::tool) hold_ = Hold::nothing;
}

QString ViewportInput::hint() const {
  if (viewport_.tool() != nullptr) return viewport_.tool()->hint();
  const QString turning = navigator_.preset() == NavigationPreset::maya
                              ? Viewport::tr("Alt and a drag orbits, pans and zooms")
                              : Viewport::tr("middle button orbits, with Shift pans; wheel zooms");
  return Viewport::tr("Click selects, with Shift more; drag selects what is in a box; %1").arg(turning);
}

bool ViewportInput::isBusyAt(const QPointF& at) const {
  return hold_ == Hold::camera || hold_ == Hold::tool || axes_.contains(at, viewport_.viewSize());
}

void ViewportInput::press(const QMouseEvent& event) {
  flight_.stop();
  const PointerEvent pointer = pointerOf(event);
  Tool* tool = viewport_.tool();
  if (hold_ == Hold::tool) {
    // Other buttons, while it has the left one.
    if (tool != nullptr) tool->press(viewport_, pointer);
    return;
  }
  const bool left = event.button() == Qt::LeftButton;
  if (left && axes_.contains(event.position(), viewport_.viewSize())) {
    hold_ = Hold::axes;
    from_ = last_ = event.position();
    return;
  }
  if (navigator_.press(pointer)) {
    hold_ = Hold::camera;
    return;
  }
  if (!left) return;
  from_ = event.position();
  hold_ = Hold::click;
  if (tool != nullptr && tool->press(viewport_, pointer)) hold_ = Hold::tool;
}

void ViewportInput::move(const QMouseEvent& event) {
  const QPointF at = event.position();
  pointer_ = at;
  if (hold_ != Hold::nothing && event.buttons() == Qt::NoButton) letGo(event);
  Tool* tool = viewport_.tool();
  if (hold_ == Hold::click && !isNear(from_, at)) hold_ = Hold::band;
  switch (hold_) {
    case Hold::axes:
      if (isNear(at, from_) && last_ == from_) return;
      navigator_.orbitBy(at - std::exchange(last_, at));
      emit cameraMoved();
      return;
    case Hold::camera:
      navigator_.move(pointerOf(event), viewport_.viewSize());
      emit cameraMoved();
      return;
    case Hold::tool:
      if (tool != nullptr) tool->move(viewport_, pointerOf(event));
      viewport_.update();
      return;
    case Hold::band:
      viewport_.update();
      return;
    case Hold::click:
    case Hold::nothing:
      break;
  }
  if (event.buttons() != Qt::NoButton) return;
  if (tool != nullptr) tool->hover(viewport_, pointerOf(event));
  hovering_.start();
  const QRectF nearAxes(0.0, viewport_.height() - kAxesReach, kAxesReach, kAxesReach);
  if (tool != nullptr || nearAxes.contains(at)) viewport_.update();
}

/// The release went to another window, such as a dialog that opened meanwhile.
void ViewportInput::letGo(const QMouseEvent& event) {
  const Hold held = std::exchange(hold_, Hold::nothing);
  navigator_.release();
  if (held == Hold::tool && viewport_.tool() != nullptr)
    viewport_.tool()->release(viewport_, pointerOf(event));
  viewport_.update();
}

void ViewportInput::release(const QMouseEvent& event) {
  const bool left = event.button() == Qt::LeftButton;
  if (hold_ == Hold::camera) {
    if (event.buttons() != Qt::NoButton) return;
    navigator_.release();
    hold_ = Hold::nothing;
    return;
  }
  if (!left) return;
  switch (std::exchange(hold_, Hold::nothing)) {
    case Hold::axes:
      releaseAxes(event.position());
      return;
    case Hold::tool:
      if (viewport_.tool() != nullptr) viewport_.tool()->release(viewport_, pointerOf(event));
      viewport_.update();
      return;
    case Hold::band: {
      const QRectF frame = QRectF(from_, event.position()).normalized();
      pointer_ = event.position();
      selectFramed(viewport_.session(), itemsIn(frame, viewport_.session(), camera_, viewport_.viewSize()),
                   event.modifiers());
      viewport_.update();
      return;
    }
    case Hold::click: {
      const Pick pick = viewport_.pickAt(event.position());
      selectPicked(viewport_.session(), pick, event.modifiers());
      emit clicked(pick);
      return;
    }
    case Hold::camera:
    case Hold::nothing:
      return;
  }
}

/// Without a drag it was a click on an axis.
void ViewportInput::releaseAxes(const QPointF& at) {
  if (last_ != from_) return;
  if (const auto axis = axes_.axisAt(at, camera_, viewport_.viewSize())) viewport_.lookAlong(*axis);
}

void ViewportInput::leave() {
  pointer_.reset();
  hovering_.stop();
  if (hover_.kind != Pick::Kind::nothing) {
    hover_ = {};
    emit hovered(hover_);
  }
  viewport_.update();
}

void ViewportInput::wheel(const QWheelEvent& event) {
  flight_.stop();
  navigator_.wheel(event, viewport_.viewSize());
  emit cameraMoved();
}

void ViewportInput::pinch(double change, const QPointF& at) {
  navigator_.pinch(change, at, viewport_.viewSize());
  emit cameraMoved();
}

bool ViewportInput::key(const QKeyEvent& event) {
  const bool escape = event.key() == Qt::Key_Escape;
  Tool* tool = viewport_.tool();
  if (escape && hold_ == Hold::band) {
    hold_ = Hold::nothing;
  } else if (tool != nullptr && tool->key(viewport_, event.key(), event.modifiers())) {
    // It has it.
  } else {
    return escape && tool != nullptr && this->escape();
  }
  viewport_.update();
  return true;
}

bool ViewportInput::escape() {
  Tool* tool = viewport_.tool();
  if (tool == nullptr) return false;
  if (tool->cancel(viewport_)) {
    forgetToolPress();
  } else {
    viewport_.setTool(nullptr);
  }
  viewport_.update();
  return true;
}

void ViewportInput::showHover() {
  if (!pointer_ || hold_ == Hold::camera || hold_ == Hold::tool) return;
  const Pick pick = viewport_.pickAt(*pointer_);
  const bool same = pick.kind == hover_.kind && pick.index == hover_.index && pick.node == hover_.node;
  hover_ = pick;
  if (!same) emit hovered(hover_);
}

}  // namespace ui
