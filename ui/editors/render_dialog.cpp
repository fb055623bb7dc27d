#include "ui/editors/render_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <numbers>

#include "ui/editors/problem_text.h"
#include "ui/panels/number_field.h"
#include "ui/picture/video.h"
#include "ui/theme/theme.h"
#include "ui/viewport/viewport.h"

namespace ui {
namespace {

constexpr int kPollMilliseconds = 80;
/// Choices that follow one another faster than this are one.
constexpr int kSettleMilliseconds = 250;
/// The preview is this high, and gets so many samples: a second or two for a first look.
constexpr int kPreviewHeight = 240;
constexpr int kPreviewSamples = 32;

enum What : int { kStill, kAllFrames };
enum From : int { kViewport, kScene };
enum LitBy : int { kStudioLamps = 1, kFromImage };

Camera cameraOf(const modeling::Camera& camera) {
  return {camera.position, camera.target, camera.fieldOfView * std::numbers::pi / 180.0, camera.aperture,
          camera.focus.value_or(0.0)};
}

QImage asQt(const Image& image) {
  const std::vector<std::uint8_t> bytes = toEightBit(image);
  return QImage(bytes.data(), image.width, image.height, 3 * image.width, QImage::Format_RGB888).copy();
}

PictureFrames framesOfMoment(const Shown& shown) {
  PictureFrames frames;
  frames.network = shown.network;
  if (shown.scene) frames.scene = *shown.scene;
  frames.framesPerSecond = frames.scene.output.fps;
  frames.frame = [moment = shown.moment](std::size_t) { return sim::Result<sim::SnapshotPointer>(moment); };
  return frames;
}

PictureFrames framesOfFootage(const std::shared_ptr<Footage>& footage) {
  PictureFrames frames;
  frames.network = footage->network();
  frames.scene = *footage->scene();
  frames.framesPerSecond = frames.scene.output.fps;
  frames.frame = [footage](std::size_t frame) { return footage->frame(frame); };
  return frames;
}

}  // namespace

RenderDialog::RenderDialog(Session& session, Viewport& viewport, QWidget* parent)
    : QDialog(parent), session_(session), viewport_(viewport) {
  setObjectName(QStringLiteral("render-dialog"));
  setWindowTitle(tr("Render"));
  setAttribute(Qt::WA_DeleteOnClose);
  resize(860, 520);
  picture_ = new QLabel(this);
  picture_->setObjectName(QStringLiteral("render-picture"));
  picture_->setAlignment(Qt::AlignCenter);
  picture_->setMinimumSize(320, 180);
  picture_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  state_ = new QLabel(this);
  state_->setObjectName(QStringLiteral("render-state"));
  state_->setWordWrap(true);
  auto* upper = new QHBoxLayout;
  upper->setSpacing(16);
  upper->addWidget(picture_, 1);
  upper->addWidget(makeChoices());
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 14, 16, 14);
  layout->setSpacing(10);
  layout->addLayout(upper, 1);
  layout->addWidget(state_);
  layout->addWidget(makeButtons());
  timer_.setInterval(kPollMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &RenderDialog::poll);
  again_.setSingleShot(true);
  again_.setInterval(kSettleMilliseconds);
  connect(&again_, &QTimer::timeout, this, &RenderDialog::startPreview);
  connect(&viewport_, &Viewport::cameraChanged, this, [this] {
    if (camera_->currentIndex() == kViewport) again_.start();
  });
  connect(&session_, &Session::shownChanged, &again_, qOverload<>(&QTimer::start));
  connect(&session_.document(), &Document::replaced, this, &QDialog::reject);
  startPreview();
}

NumberField* RenderDialog::numberField(const QString& name, double least, double most, double value,
                                       bool whole, const QString& tip) {
  NumberFormat format;
  format.least = least;
  format.most = most;
  format.whole = whole;
  format.step = whole ? 1.0 : 0.05;
  auto* field = new NumberField(format, this);
  field->setObjectName(name);
  field->setValue(value);
  field->setDefault(value);
  field->setToolTip(tip);
  connect(field, &NumberField::edited, this, [this] { again_.start(); });
  return field;
}

QComboBox* RenderDialog::combo(const QString& name, const QStringList& items) {
  auto* made = new QComboBox(this);
  made->setObjectName(name);
  made->addItems(items);
  connect(made, &QComboBox::currentIndexChanged, &again_, qOverload<>(&QTimer::start));
  return made;
}

/// In the order of the scene's choices, which are what they replace.
void RenderDialog::addStyle(QFormLayout& form) {
  const QString asScene = tr("As in the scene");
  surface_ = combo(QStringLiteral("render-surface"), {asScene, tr("Of the cells"), tr("Level surface")});
  ground_ = combo(QStringLiteral("render-ground"), {asScene, tr("Studio floor"), tr("None"), tr("Plain"),
                                                    tr("Checker"), tr("Wood"), tr("Shadows only")});
  backdrop_ = combo(QStringLiteral("render-backdrop"),
                    {asScene, tr("Studio"), tr("Colour"), tr("Gradient"), tr("Environment")});
  light_ = combo(QStringLiteral("render-light"), {asScene, tr("Studio lamps"), tr("From an image…")});
  light_->setToolTip(tr("An image of all around: OpenEXR, Radiance .hdr or PNG"));
  connect(light_, &QComboBox::activated, this, [this](int index) {
    if (index == kFromImage) askForEnvironment();
  });
  form.addRow(tr("Surface"), surface_);
  form.addRow(tr("Ground"), ground_);
  form.addRow(tr("Backdrop"), backdrop_);
  form.addRow(tr("Light"), light_);
}

void RenderDialog::askForEnvironment() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Image of all around"), environment_,
                                                    tr("Images (*.exr *.hdr *.png)"));
  if (!file.isEmpty()) environment_ = file;
  if (environment_.isEmpty()) light_->setCurrentIndex(0);
  again_.start();
}

modeling::PictureStyle RenderDialog::styleFrom(modeling::PictureStyle style) const {
  if (const int index = surface_->currentIndex(); index > 0)
    style.surface = static_cast<modeling::PictureSurface>(index - 1);
  if (const int index = ground_->currentIndex(); index > 0)
    style.ground.kind = static_cast<modeling::GroundKind>(index - 1);
  if (const int index = backdrop_->currentIndex(); index > 0)
    style.backdrop.kind = static_cast<modeling::BackdropKind>(index - 1);
  if (light_->currentIndex() == kStudioLamps) style.environment.image.clear();
  if (light_->currentIndex() == kFromImage) style.environment.image = environment_.toStdString();
  return style;
}

QWidget* RenderDialog::makeChoices() {
  // Made in the order in which Tab goes through them.
  auto* box = new QWidget(this);
  auto* form = new QFormLayout(box);
  form->setContentsMargins(0, 0, 0, 0);
  what_ = combo(QStringLiteral("render-what"), {tr("This moment"), tr("All frames of the take")});
  camera_ = combo(QStringLiteral("render-camera"), {tr("As in the viewport"), tr("Of the scene")});
  width_ = numberField(QStringLiteral("render-width"), 16, 8192, 1280, true, tr("Pixels"));
  height_ = numberField(QStringLiteral("render-height"), 16, 8192, 720, true, tr("Pixels"));
  samples_ = numberField(QStringLiteral("render-samples"), 1, 65536, 64, true,
                         tr("Paths a pixel: four times as many halve the noise"));
  aperture_ = numberField(QStringLiteral("render-aperture"), 0, 100, 0, false,
                          tr("Diameter of the lens, cm: what is not as far as the target is blurred"));
  shutter_ = numberField(QStringLiteral("render-shutter"), 0, 1, 0, false,
                         tr("Share of a frame's time for which it is open: what moves is blurred"));
  looseNodes_ = combo(QStringLiteral("render-loose"),
                      {tr("Shards"), tr("Tetrahedra"), tr("Balls"), tr("Given to neighbours")});
  looseNodes_->setToolTip(tr("How nodes are drawn that nothing holds any more"));
  form->addRow(tr("Picture of"), what_);
  form->addRow(tr("Camera"), camera_);
  form->addRow(tr("Width"), width_);
  form->addRow(tr("Height"), height_);
  form->addRow(tr("Samples"), samples_);
  form->addRow(tr("Aperture, cm"), aperture_);
  form->addRow(tr("Shutter"), shutter_);
  form->addRow(tr("Loose nodes"), looseNodes_);
  addStyle(*form);
  sixteenBit_ = new QCheckBox(tr("16 bit a channel"), box);
  sixteenBit_->setToolTip(tr("Of PNG files: for those who go on working with the picture"));
  form->addRow(QString(), sixteenBit_);
  box->setFixedWidth(290);
  return box;
}

QWidget* RenderDialog::makeButtons() {
  auto* box = new QWidget(this);
  progress_ = new QProgressBar(box);
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  QSizePolicy policy = progress_->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  progress_->setSizePolicy(policy);
  auto* close = new QPushButton(tr("Close"), box);
  render_ = new QPushButton(box);
  render_->setObjectName(QStringLiteral("render-start"));
  render_->setDefault(true);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(progress_, 1);
  row->addWidget(close);
  row->addWidget(render_);
  connect(render_, &QPushButton::clicked, this, [this] {
    if (!rendering_) return askForFile();
    stopped_ = true;
    job_->stop();
  });
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  return box;
}

std::optional<PictureJob::Order> RenderDialog::order() const {
  const Shown& shown = session_.shown();
  const auto take = session_.takes().current();
  if (!shown.network || !shown.moment) return std::nullopt;
  PictureJob::Order order;
  if (what_->currentIndex() == kAllFrames && take) {
    const std::shared_ptr<Footage>& footage = session_.takes()[*take].footage;
    if (footage->frameCount() == 0) return std::nullopt;
    order.frames = framesOfFootage(footage);
    order.last = footage->frameCount() - 1;
  } else {
    order.frames = framesOfMoment(shown);
  }
  order.framesPerSecond = order.frames.framesPerSecond;
  order.frames.folder = session_.document().folder();
  order.frames.scene.view.picture = styleFrom(order.frames.scene.view.picture);
  if (camera_->currentIndex() == kViewport) order.camera = cameraOf(viewport_.camera().asScene());
  order.choices.looseNodes = static_cast<sim::LooseNodes>(looseNodes_->currentIndex());
  order.choices.shutter = shutter_->value().value_or(0.0);
  if (const double aperture = aperture_->value().value_or(0.0); aperture > 0.0)
    order.choices.aperture = aperture;
  const auto whole = [](const NumberField& field) { return static_cast<int>(field.value().value_or(1.0)); };
  order.settings.width = whole(*width_);
  order.settings.height = whole(*height_);
  order.settings.samples = whole(*samples_);
  order.depth = sixteenBit_->isChecked() ? PngDepth::sixteenBit : PngDepth::eightBit;
  return order;
}

void RenderDialog::startPreview() {
  if (rendering_) return;
  file_.clear();
  auto wanted = order();
  job_.reset();
  view_ = {};
  if (wanted) {
    wanted->settings.width = std::max(1, kPreviewHeight * wanted->settings.width / wanted->settings.height);
    wanted->settings.height = kPreviewHeight;
    wanted->settings.samples = kPreviewSamples;
    wanted->first = wanted->last;
    job_ = std::make_unique<PictureJob>(std::move(*wanted));
    timer_.start();
  }
  showState();
}

void RenderDialog::askForFile() {
  const bool sequence = what_->currentIndex() == kAllFrames;
  const QString kinds = sequence ? tr("Film (*.mp4 *.webm *.gif *.webp *.apng);;Numbered pictures (*.png)")
                                 : tr("Picture (*.png)");
  QString file = QFileDialog::getSaveFileName(this, tr("Render to"), QString(), kinds);
  if (file.isEmpty()) return;
  if (QFileInfo(file).suffix().isEmpty()) file += sequence ? QStringLiteral(".mp4") : QStringLiteral(".png");
  render(file.toStdString());
}

void RenderDialog::render(const std::filesystem::path& out) {
  auto wanted = order();
  if (!wanted) return;
  wanted->out = out;
  file_ = QString::fromStdString(out.string());
  job_.reset();
  view_ = {};
  rendering_ = true;
  stopped_ = false;
  job_ = std::make_unique<PictureJob>(std::move(*wanted));
  timer_.start();
  showState();
}

void RenderDialog::poll() {
  if (!job_) return timer_.stop();
  const std::shared_ptr<const Image> before = view_.image;
  PictureJob::View now = job_->view();
  // Between two frames, or after a stop, the picture before stays.
  if (!now.image) now.image = before;
  view_ = std::move(now);
  if (view_.image != before) showImage();
  if (view_.ended) {
    timer_.stop();
    rendering_ = false;
  }
  showState();
}

void RenderDialog::showImage() {
  if (!view_.image) return;
  const qreal ratio = devicePixelRatioF();
  QPixmap pixmap = QPixmap::fromImage(asQt(*view_.image))
                       .scaled(ratio * picture_->size(), Qt::KeepAspectRatio, Qt::SmoothTransformation);
  pixmap.setDevicePixelRatio(ratio);
  picture_->setPixmap(pixmap);
}

void RenderDialog::resizeEvent(QResizeEvent* event) {
  QDialog::resizeEvent(event);
  showImage();
}

void RenderDialog::showState() {
  render_->setText(rendering_ ? tr("Stop") : tr("Render…"));
  render_->setEnabled(rendering_ || session_.shown().moment != nullptr);
  progress_->setVisible(rendering_);
  progress_->setValue(static_cast<int>(1000.0 * view_.share));
  for (QWidget* widget : findChildren<QWidget*>()) {
    if (qobject_cast<QComboBox*>(widget) != nullptr || qobject_cast<NumberField*>(widget) != nullptr)
      widget->setEnabled(!rendering_);
  }
  QString text;
  if (view_.problem) {
    text = textOf(*view_.problem);
  } else if (rendering_) {
    text = tr("Drawing, %1 %").arg(static_cast<int>(100.0 * view_.share));
  } else if (!file_.isEmpty() && view_.ended) {
    text = stopped_ ? tr("Stopped.") : tr("Written to %1").arg(file_);
  } else if (!session_.shown().moment) {
    text = tr("There is nothing to draw yet.");
  } else if (!view_.ended) {
    text = tr("Drawing a preview…");
  } else {
    text = tr("A preview, with few samples.");
  }
  state_->setText(text);
}

}  // namespace ui
