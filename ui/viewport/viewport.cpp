#include "ui/viewport/viewport.h"

#include <QHelpEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QNativeGestureEvent>
#include <QOpenGLContext>
#include <QPainter>
#include <QTimer>
#include <QToolTip>
#include <QWheelEvent>

#include "ui/theme/theme.h"
#include "ui/viewport/break_history.h"
#include "ui/viewport/camera_flight.h"
#include "ui/viewport/hover_text.h"
#include "ui/viewport/painted_overlay.h"
#include "ui/viewport/pick_resolver.h"
#include "ui/viewport/viewport_overlay.h"
#include "ui/viewport/viewport_renderer.h"

namespace ui {
namespace {

/// Logical pixels.
constexpr double kPickReach = 5.0;

}  // namespace

Viewport::Viewport(Session& session, QWidget* parent)
    : QOpenGLWidget(parent),
      session_(session),
      flight_(new CameraFlight(camera_, this)),
      breaks_(std::make_unique<BreakHistory>()),
      feed_(session),
      input_(*this, camera_, *flight_) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(160, 120);
  connect(&feed_, &DrawFeed::changed, this, [this] {
    frameFirst();
    update();
  });
  connect(&feed_, &DrawFeed::failed, &session_, &Session::report);
  connect(&input_, &ViewportInput::cameraMoved, this, &Viewport::moved);
  connect(&input_, &ViewportInput::hovered, this, &Viewport::hovered);
  connect(&input_, &ViewportInput::clicked, this, &Viewport::clicked);
  connect(&session_, &Session::previewChanged, this, &Viewport::frameFirst);
  connect(&session_.document(), &Document::replaced, this, [this] { frameWhenShown_ = true; });
  connect(&session_.selection(), &Selection::changed, this, qOverload<>(&QWidget::update));
  connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
  connect(flight_, &CameraFlight::moved, this, &Viewport::moved);
}

Viewport::~Viewport() {
  // The context ends after this, and would tell it.
  if (context() != nullptr) disconnect(context(), nullptr, this, nullptr);
  destroyRenderer();
}

void Viewport::destroyRenderer() {
  if (!renderer_) return;
  makeCurrent();
  renderer_.reset();
  doneCurrent();
}

void Viewport::setViewSettings(const ViewSettings& settings) {
  if (settings == feed_.settings()) return;
  heartbeat_.listen(settings.statistics);
  feed_.setSettings(settings);
  emit viewSettingsChanged();
}

void Viewport::frameFirst() {
  const DrawData& content = *drawn();
  if (!frameWhenShown_ || session_.isBuilding() || !content.shown.scene) return;
  // What is drawn may still be of the scene before.
  const bool present = content.shown.recorded
                           ? session_.playback().footage() && session_.shown().recorded &&
                                 !session_.awaitedFrame() && content.shown.network == session_.shown().network
                           : content.shown.scene.get() == &session_.preview()->scene;
  if (!present) return;
  if (content.box.isEmpty() && content.colliders.empty()) return;
  // A scene that begins with nothing but a floor is framed once more when something stands on it.
  frameWhenShown_ = content.box.isEmpty();
  if (const auto& camera = content.shown.scene->view.camera) {
    camera_.set(*camera);
    // Made for a picture of other proportions, it may cut off what is to be seen first.
    for (int step = 0; step < 20 && !camera_.sees(content.box, viewSize()); ++step)
      camera_.look(camera_.target(), 1.06 * camera_.distance(), camera_.azimuth(), camera_.elevation());
  } else {
    camera_ = framed(boxOfAll(content));
  }
  moved();
}

Eigen::AlignedBox3d Viewport::selectionBox() const {
  return boxOfOutlined(*drawn(), marked());
}

ViewCamera Viewport::framed(const Eigen::AlignedBox3d& box) const {
  ViewCamera camera = camera_;
  camera.frame(box, viewSize());
  return camera;
}

void Viewport::frameAll() {
  flyTo(framed(boxOfAll(*drawn())));
}

void Viewport::frameSelection() {
  const Eigen::AlignedBox3d box = selectionBox();
  flyTo(framed(box.isEmpty() ? boxOfAll(*drawn()) : box));
}

void Viewport::lookAlong(ViewCamera::Axis axis) {
  ViewCamera camera = camera_;
  camera.lookAlong(axis);
  flyTo(camera);
}

void Viewport::setOrthographic(bool orthographic) {
  if (orthographic == camera_.isOrthographic()) return;
  camera_.setOrthographic(orthographic);
  moved();
}

void Viewport::flyTo(const ViewCamera& camera) {
  if (!isVisible()) {
    camera_ = camera;
    moved();
    return;
  }
  flight_->flyTo(camera);
}

void Viewport::moved() {
  update();
  emit cameraChanged();
}

void Viewport::setTool(std::unique_ptr<Tool> tool) {
  if (tool_) tool_->cancel(*this);
  input_.forgetToolPress();
  tool_ = std::move(tool);
  setCursor(tool_ ? tool_->cursor() : QCursor(Qt::ArrowCursor));
  emit toolChanged();
  update();
}

void Viewport::sayWhatIsMissing(const QString& why) {
  if (missing_ != nullptr) return;
  missing_ =
      new QLabel(tr("<b>There is no picture here.</b><br>%1<br>Scenes can be edited, simulated and saved "
                    "all the same.")
                     .arg(why.toHtmlEscaped()),
                 this);
  missing_->setObjectName("missingPicture");
  missing_->setAlignment(Qt::AlignCenter);
  missing_->setWordWrap(true);
  missing_->setMargin(24);
  missing_->setAutoFillBackground(true);
  missing_->setGeometry(rect());
  missing_->show();
  missing_->raise();
}

void Viewport::showEvent(QShowEvent* event) {
  QOpenGLWidget::showEvent(event);
  // Whether there is a context is known once the window is on the screen.
  QTimer::singleShot(0, this, [this] {
    if (!isValid()) sayWhatIsMissing(tr("The viewport needs OpenGL 3.3, which this display does not offer."));
  });
}

void Viewport::resizeEvent(QResizeEvent* event) {
  QOpenGLWidget::resizeEvent(event);
  if (missing_ != nullptr) missing_->setGeometry(rect());
}

void Viewport::initializeGL() {
  // Comes again with another context where the viewport is put into another window.
  connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &Viewport::destroyRenderer);
  QString why;
  renderer_ = ViewportRenderer::create(why);
  if (!renderer_) sayWhatIsMissing(why);
}

MarkedThings Viewport::marked() const {
  return markedThings(*drawn(), session_.document().scene(), session_.selection());
}

PictureFrame Viewport::pictureFrame() const {
  return {camera_, viewSize(), devicePixelRatioF(), defaultFramebufferObject(), Theme::instance().colours(),
          marked()};
}

void Viewport::paintGL() {
  if (!renderer_) return;
  renderer_->show(drawn());
  renderer_->paint(pictureFrame());
  paintOver();
  noteHint();
}

void Viewport::paintOver() {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  PaintedOverlay overlay(painter, camera_, viewSize());
  if (viewSettings().invisibleColliders) paintInvisibleColliders(overlay, *drawn());
  for (const auto& paint : overlays_) paint(overlay);
  if (tool_) tool_->draw(*this, overlay);
  AxisGizmo().paint(painter, camera_, viewSize(), input_.pointer());
  paintLegends(painter, viewSize(), *drawn());
  if (viewSettings().statistics)
    paintStatistics(painter, *drawn(), renderer_->statistics(), heartbeat_.longestWait());
  paintBand(painter, input_.band());
}

void Viewport::noteHint() {
  const QString hint = input_.hint();
  if (hint == hint_) return;
  hint_ = hint;
  emit hintChanged(hint_);
}

DrawStatistics Viewport::statistics() const {
  return renderer_ ? renderer_->statistics() : DrawStatistics{};
}

Pick Viewport::pickAt(const QPointF& pixel) {
  if (!renderer_) return {};
  makeCurrent();
  renderer_->show(drawn());
  const PickedThing thing = renderer_->pick(pictureFrame(), pixel, kPickReach);
  doneCurrent();
  return resolved(thing, *drawn(), session_.document().scene());
}

QString Viewport::describe(const Pick& pick) {
  const std::shared_ptr<Footage>& footage =
      drawn()->shown.live ? session_.run()->footage : session_.playback().footage();
  return hoverText(pick, *drawn(), session_.document().scene(), *breaks_, footage);
}

bool Viewport::showToolTip(const QPoint& at) {
  if (input_.isBusyAt(at)) return true;
  const QString text = describe(pickAt(at));
  if (text.isEmpty()) {
    QToolTip::hideText();
  } else {
    QToolTip::showText(mapToGlobal(at), text, this);
  }
  return true;
}

bool Viewport::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) return showToolTip(static_cast<QHelpEvent*>(event)->pos());
  if (event->type() == QEvent::NativeGesture) {
    const auto& gesture = static_cast<QNativeGestureEvent&>(*event);
    if (gesture.gestureType() == Qt::ZoomNativeGesture) {
      input_.pinch(gesture.value(), gesture.position());
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
  input_.press(*event);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  input_.move(*event);
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  input_.release(*event);
}

void Viewport::leaveEvent(QEvent* event) {
  QOpenGLWidget::leaveEvent(event);
  input_.leave();
}

void Viewport::wheelEvent(QWheelEvent* event) {
  input_.wheel(*event);
  event->accept();
}

void Viewport::focusOutEvent(QFocusEvent* event) {
  QOpenGLWidget::focusOutEvent(event);
  const bool back = event->reason() == Qt::PopupFocusReason ||
                    event->reason() == Qt::ActiveWindowFocusReason ||
                    event->reason() == Qt::MenuBarFocusReason;
  if (!back && tool_) tool_->leave(*this);
}

void Viewport::keyPressEvent(QKeyEvent* event) {
  if (!input_.key(*event)) QOpenGLWidget::keyPressEvent(event);
}

}  // namespace ui
