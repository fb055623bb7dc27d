#include <QHelpEvent>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QToolTip>
#include <QWheelEvent>

#include "ui/document/scene_edits.h"
#include "ui/viewport/camera_flight.h"
#include "ui/viewport/viewport.h"
#include "ui/viewport/viewport_renderer.h"

namespace ui {
namespace {

/// A press that moves no farther, in logical pixels, is a click.
constexpr double kClickReach = 4.0;

PointerEvent pointerOf(const QMouseEvent& event) {
  return {event.position(), event.buttons(), event.modifiers()};
}

bool isNear(const QPointF& a, const QPointF& b) {
  return (a - b).manhattanLength() <= kClickReach;
}

}  // namespace

bool Viewport::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) return showToolTip(static_cast<QHelpEvent*>(event)->pos());
  if (event->type() == QEvent::NativeGesture) {
    const auto& gesture = static_cast<QNativeGestureEvent&>(*event);
    if (gesture.gestureType() == Qt::ZoomNativeGesture) {
      navigator_.pinch(gesture.value(), gesture.position(), viewSize());
      moved();
      return true;
    }
  }
  if (event->type() == QEvent::ShortcutOverride && tool_) {
    // Digits typed into a drag are no shortcuts of views.
    const auto& key = static_cast<QKeyEvent&>(*event);
    if (tool_->wantsKey(key.key(), key.modifiers())) {
      event->accept();
      return true;
    }
  }
  return QOpenGLWidget::event(event);
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  setFocus(Qt::MouseFocusReason);
  flight_->stop();
  const PointerEvent pointer = pointerOf(*event);
  if (toolPressed_) {
    tool_->press(*this, pointer);
    return;
  }
  if (event->button() == Qt::LeftButton && axisGizmo_.contains(event->position(), viewSize())) {
    gizmoPress_ = event->position();
    gizmoLast_ = event->position();
    return;
  }
  if (navigator_.press(pointer)) return;
  if (tool_ && event->button() == Qt::LeftButton && tool_->press(*this, pointer)) {
    toolPressed_ = true;
    return;
  }
  if (event->button() == Qt::LeftButton) pressed_ = event->position();
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  pointer_ = event->position();
  const PointerEvent pointer = pointerOf(*event);
  if (gizmoPress_) {
    if (!isNear(event->position(), *gizmoPress_) || gizmoLast_ != *gizmoPress_) {
      navigator_.orbitBy(event->position() - gizmoLast_);
      gizmoLast_ = event->position();
      moved();
    }
    return;
  }
  if (navigator_.isMoving()) {
    navigator_.move(pointer, viewSize());
    moved();
    return;
  }
  if (tool_ && toolPressed_) {
    tool_->move(*this, pointer);
    update();
    return;
  }
  if (pressed_ && !isNear(*pressed_, event->position())) bandFrom_ = std::exchange(pressed_, std::nullopt);
  if (bandFrom_) update();
  if (event->buttons() != Qt::NoButton) return;
  if (tool_) tool_->hover(*this, pointer);
  hovering_.start();
  // The axes light up under the pointer.
  const QPointF reach(110.0, 110.0);
  if (tool_ || QRectF(QPointF(0.0, height() - reach.y()), QSizeF(reach.x(), reach.y())).contains(*pointer_))
    update();
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  const PointerEvent pointer = pointerOf(*event);
  if (gizmoPress_ && event->button() == Qt::LeftButton) {
    const bool clicked = gizmoLast_ == *gizmoPress_;
    gizmoPress_.reset();
    if (const auto axis = axisGizmo_.axisAt(event->position(), camera_, viewSize()); clicked && axis)
      lookAlong(*axis);
    return;
  }
  if (navigator_.isMoving() && event->buttons() == Qt::NoButton) {
    navigator_.release();
    return;
  }
  if (tool_ && toolPressed_) {
    if (event->button() == Qt::LeftButton) {
      toolPressed_ = false;
      tool_->release(*this, pointer);
      update();
    }
    return;
  }
  if (event->button() == Qt::LeftButton && bandFrom_) {
    pointer_ = event->position();
    selectInBand(event->modifiers());
    return;
  }
  if (event->button() == Qt::LeftButton && pressed_) {
    pressed_.reset();
    const Pick pick = pickAt(event->position());
    select(pick, event->modifiers());
    emit clicked(pick);
  }
}

void Viewport::leaveEvent(QEvent* event) {
  QOpenGLWidget::leaveEvent(event);
  pointer_.reset();
  hovering_.stop();
  if (hover_.kind != Pick::Kind::nothing) {
    hover_ = {};
    emit hovered(hover_);
  }
  update();
}

void Viewport::wheelEvent(QWheelEvent* event) {
  flight_->stop();
  navigator_.wheel(*event, viewSize());
  event->accept();
  moved();
}

void Viewport::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (key == Qt::Key_Escape && bandFrom_) {
    bandFrom_.reset();
    update();
    return;
  }
  if (tool_ && tool_->key(*this, key, event->modifiers())) {
    update();
    return;
  }
  if (key == Qt::Key_Escape && tool_) {
    if (tool_->cancel(*this)) {
      toolPressed_ = false;
    } else {
      setTool(nullptr);
    }
    update();
    return;
  }
  QOpenGLWidget::keyPressEvent(event);
}

void Viewport::showHover() {
  if (!pointer_ || navigator_.isMoving() || toolPressed_) return;
  const Pick pick = pickAt(*pointer_);
  const bool same = pick.kind == hover_.kind && pick.index == hover_.index && pick.node == hover_.node;
  hover_ = pick;
  if (!same) emit hovered(hover_);
}

bool Viewport::showToolTip(const QPoint& at) {
  if (navigator_.isMoving() || toolPressed_ || axisGizmo_.contains(at, viewSize())) return true;
  const QString text = describe(pickAt(at));
  if (text.isEmpty()) {
    QToolTip::hideText();
  } else {
    QToolTip::showText(mapToGlobal(at), text, this);
  }
  return true;
}

}  // namespace ui
