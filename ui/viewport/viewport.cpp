#include "ui/viewport/viewport.h"

#include <QLabel>
#include <QOpenGLContext>

#include "ui/document/scene_edits.h"
#include "ui/theme/theme.h"
#include "ui/viewport/break_history.h"
#include "ui/viewport/camera_flight.h"
#include "ui/viewport/collider_shape.h"
#include "ui/viewport/pick_resolver.h"
#include "ui/viewport/viewport_renderer.h"

namespace ui {
namespace {

/// How often it is looked whether draw data is ready.
constexpr int kPreparingMilliseconds = 8;
/// The pointer has to rest so long before what is under it is looked for.
constexpr int kHoverMilliseconds = 50;
/// Logical pixels.
constexpr double kPickReach = 5.0;

}  // namespace

Viewport::Viewport(Session& session, QWidget* parent)
    : QOpenGLWidget(parent),
      session_(session),
      navigator_(camera_),
      flight_(new CameraFlight(camera_, this)),
      breaks_(std::make_unique<BreakHistory>()),
      drawn_(std::make_shared<const DrawData>()) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(160, 120);
  preparing_.setInterval(kPreparingMilliseconds);
  preparing_.setTimerType(Qt::PreciseTimer);
  hovering_.setInterval(kHoverMilliseconds);
  hovering_.setSingleShot(true);
  connect(&preparing_, &QTimer::timeout, this, &Viewport::takePrepared);
  connect(&hovering_, &QTimer::timeout, this, &Viewport::showHover);
  connect(&session_, &Session::shownChanged, this, &Viewport::prepare);
  connect(&session_, &Session::previewChanged, this, &Viewport::frameFirst);
  connect(&session_.document(), &Document::replaced, this, [this] { frameWhenShown_ = true; });
  connect(&session_.document(), &Document::sceneChanged, this, &Viewport::prepareIfHidden);
  connect(&session_.selection(), &Selection::changed, this, qOverload<>(&QWidget::update));
  connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
  connect(flight_, &CameraFlight::moved, this, &Viewport::moved);
  prepare();
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
  if (settings == viewSettings_) return;
  viewSettings_ = settings;
  heartbeat_.listen(settings.statistics);
  prepare();
  emit viewSettingsChanged();
}

ViewSettings Viewport::effectiveSettings() const {
  ViewSettings settings = viewSettings_;
  const std::vector<std::string>& hidden = session_.document().scene().view.hidden;
  settings.hiddenParts.insert(settings.hiddenParts.end(), hidden.begin(), hidden.end());
  return settings;
}

void Viewport::prepareIfHidden() {
  if (effectiveSettings() != requested_) prepare();
}

void Viewport::prepare() {
  requested_ = effectiveSettings();
  preparer_.request(session_.shown(), requested_);
  preparing_.start();
}

void Viewport::takePrepared() {
  // Asked before the newest is taken: what is ready in between comes with the next look.
  if (!preparer_.isBusy()) preparing_.stop();
  std::shared_ptr<const DrawData> newest = preparer_.newest();
  if (newest == drawn_) return;
  drawn_ = std::move(newest);
  frameFirst();
  update();
}

bool Viewport::isUpToDate() const {
  const Shown& shown = session_.shown();
  return !preparer_.isBusy() && drawn_ == preparer_.newest() && drawn_->settings == effectiveSettings() &&
         drawn_->shown.network == shown.network && drawn_->shown.moment == shown.moment;
}

void Viewport::frameFirst() {
  if (!frameWhenShown_ || session_.isBuilding() || !drawn_->shown.scene) return;
  if (drawn_->shown.network != session_.shown().network) return;
  if (drawn_->box.isEmpty() && drawn_->colliders.empty()) return;
  frameWhenShown_ = false;
  if (const auto& camera = drawn_->shown.scene->view.camera) {
    camera_.set(*camera);
    // Made for a picture of other proportions, it may cut off what is to be seen first.
    for (int step = 0; step < 20 && !camera_.sees(drawn_->box, viewSize()); ++step)
      camera_.look(camera_.target(), 1.06 * camera_.distance(), camera_.azimuth(), camera_.elevation());
  } else {
    camera_ = framed(everything());
  }
  moved();
}

Eigen::AlignedBox3d Viewport::everything() const {
  Eigen::AlignedBox3d box = drawn_->box;
  for (const sim::Collider& collider : drawn_->colliders) box.extend(boxOf(collider));
  if (box.isEmpty()) return box;
  // What is in the air is seen with the floor on which it will fall.
  const sim::Vec3 middle = box.center();
  for (const sim::Collider& collider : drawn_->colliders) {
    if (!collider.isFloor()) continue;
    const sim::Vec3 normal = collider.rotation * sim::Vec3::UnitZ();
    box.extend(sim::Vec3(middle - normal.dot(middle - collider.position) * normal));
  }
  return box;
}

Eigen::AlignedBox3d Viewport::selectionBox() const {
  Eigen::AlignedBox3d box;
  const PictureFrame frame = pictureFrame();
  for (const std::size_t collider : frame.outlinedColliders) {
    box.extend(boxOf(drawn_->colliders[collider]));
    box.extend(drawn_->colliders[collider].position);
  }
  if (frame.outlinedParts.empty() || !drawn_->motion) return box;
  const sim::Network& network = *drawn_->shown.network;
  std::vector<std::uint8_t> chosen(network.partNames.size(), 0);
  for (const sim::PartIndex part : frame.outlinedParts) chosen[part] = 1;
  for (std::size_t node = 0; node < network.nodeCount(); ++node) {
    if (network.nodeParts[node] >= chosen.size() || chosen[network.nodeParts[node]] == 0) continue;
    box.extend(Eigen::Map<const Eigen::Vector3f>(drawn_->motion->positions[node].data()).cast<double>());
  }
  return box;
}

ViewCamera Viewport::framed(const Eigen::AlignedBox3d& box) const {
  ViewCamera camera = camera_;
  camera.frame(box, viewSize());
  return camera;
}

void Viewport::frameAll() {
  flyTo(framed(everything()));
}

void Viewport::frameSelection() {
  const Eigen::AlignedBox3d box = selectionBox();
  flyTo(framed(box.isEmpty() ? everything() : box));
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
  toolPressed_ = false;
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

PictureFrame Viewport::pictureFrame() const {
  PictureFrame frame{camera_,
                     viewSize(),
                     devicePixelRatioF(),
                     defaultFramebufferObject(),
                     Theme::instance().colours(),
                     {},
                     {},
                     {},
                     {}};
  const modeling::Scene& scene = session_.document().scene();
  for (const Item& item : session_.selection().items()) {
    if (item.kind == ItemKind::part && item.index < scene.parts.size() && drawn_->shown.network) {
      const std::vector<std::string>& names = drawn_->shown.network->partNames;
      for (std::size_t part = 0; part < names.size(); ++part) {
        if (names[part] == scene.parts[item.index].name)
          frame.outlinedParts.push_back(static_cast<sim::PartIndex>(part));
      }
    }
    if (item.kind != ItemKind::collider || item.index >= scene.environment.colliders.size()) continue;
    for (std::size_t i = 0; i < drawn_->colliders.size(); ++i) {
      if (drawn_->colliders[i].name == scene.environment.colliders[item.index].name)
        frame.outlinedColliders.push_back(i);
    }
  }
  addLocked(frame);
  return frame;
}

/// Clicks pass over what is locked.
void Viewport::addLocked(PictureFrame& frame) const {
  const modeling::Scene& scene = session_.document().scene();
  if (scene.view.locked.empty()) return;
  const auto locked = [&](ItemKind kind, const std::string& name) {
    const std::optional<Item> item = itemNamed(scene, kind, name);
    return item && isLocked(scene, *item);
  };
  if (drawn_->shown.network) {
    const std::vector<std::string>& names = drawn_->shown.network->partNames;
    for (std::size_t part = 0; part < names.size(); ++part) {
      if (locked(ItemKind::part, names[part])) frame.passedParts.push_back(static_cast<sim::PartIndex>(part));
    }
  }
  for (std::size_t i = 0; i < drawn_->colliders.size(); ++i) {
    if (locked(ItemKind::collider, drawn_->colliders[i].name)) frame.passedColliders.push_back(i);
  }
}

void Viewport::paintGL() {
  if (!renderer_) return;
  renderer_->show(drawn_);
  renderer_->paint(pictureFrame());
  paintOver();
  noteHint();
}

DrawStatistics Viewport::statistics() const {
  return renderer_ ? renderer_->statistics() : DrawStatistics{};
}

Pick Viewport::pickAt(const QPointF& pixel) {
  if (!renderer_) return {};
  makeCurrent();
  renderer_->show(drawn_);
  const PickedThing thing = renderer_->pick(pictureFrame(), pixel, kPickReach);
  doneCurrent();
  return resolved(thing, *drawn_, session_.document().scene());
}

}  // namespace ui
