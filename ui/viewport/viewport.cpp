#include "ui/viewport/viewport.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "ui/theme/theme.h"
#include "ui/viewport/viewport_renderer.h"

namespace ui {

Viewport::Viewport(Session& session, QWidget* parent) : QOpenGLWidget(parent), session_(session) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  connect(&session_, &Session::shownChanged, this, qOverload<>(&QWidget::update));
}

Viewport::~Viewport() {
  makeCurrent();
  renderer_.reset();
  doneCurrent();
}

void Viewport::frameAll() {
  Eigen::AlignedBox3d box;
  if (const sim::SnapshotPointer& moment = session_.shown().moment) {
    for (const sim::Vec3& position : moment->positions) box.extend(position);
  }
  camera_.frame(box, viewSize());
  update();
}

void Viewport::frameSelection() {
  frameAll();
}

Pick Viewport::pickAt(const QPointF&) {
  return {};
}

void Viewport::setTool(std::unique_ptr<Tool> tool) {
  tool_ = std::move(tool);
  emit toolChanged();
  update();
}

void Viewport::initializeGL() {
  renderer_ = std::make_unique<ViewportRenderer>();
  if (!renderer_->initialise()) renderer_.reset();
}

void Viewport::paintGL() {
  if (renderer_) renderer_->clear(Theme::instance().colours().viewBottom);
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  lastPointer_ = event->position();
  if (tool_) tool_->press(*this, {event->position(), event->buttons(), event->modifiers()});
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  const QPointF moved = event->position() - lastPointer_;
  lastPointer_ = event->position();
  if (event->buttons() & Qt::MiddleButton) {
    camera_.orbit(-0.01 * moved.x(), 0.01 * moved.y());
    update();
  } else if (tool_) {
    tool_->move(*this, {event->position(), event->buttons(), event->modifiers()});
  }
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  if (tool_) tool_->release(*this, {event->position(), event->buttons(), event->modifiers()});
}

void Viewport::wheelEvent(QWheelEvent* event) {
  camera_.zoom(std::pow(0.999, event->angleDelta().y()), event->position(), viewSize());
  update();
}

}  // namespace ui
