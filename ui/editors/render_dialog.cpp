#include "ui/editors/render_dialog.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/editors/problem_text.h"
#include "ui/editors/render_choices.h"
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

QImage asQt(const Image& image) {
  const std::vector<std::uint8_t> bytes = toEightBit(image);
  return QImage(bytes.data(), image.width, image.height, 3 * image.width, QImage::Format_RGB888).copy();
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
  choices_ = new RenderChoices(this);
  upper->addWidget(choices_);
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
  connect(choices_, &RenderChoices::changed, &again_, qOverload<>(&QTimer::start));
  connect(&viewport_, &Viewport::cameraChanged, this, [this] {
    if (choices_->wantsViewportCamera()) again_.start();
  });
  connect(&session_, &Session::shownChanged, &again_, qOverload<>(&QTimer::start));
  connect(&session_.document(), &Document::replaced, this, &QDialog::reject);
  startPreview();
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

void RenderDialog::startPreview() {
  if (rendering_) return;
  file_.clear();
  auto wanted = choices_->order(session_, viewport_);
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
  const bool sequence = choices_->wantsAllFrames();
  const QString kinds = sequence ? tr("Film (*.mp4 *.webm *.gif *.webp *.apng);;Numbered pictures (*.png)")
                                 : tr("Picture (*.png)");
  QString file = QFileDialog::getSaveFileName(this, tr("Render to"), QString(), kinds);
  if (file.isEmpty()) return;
  if (QFileInfo(file).suffix().isEmpty()) file += sequence ? QStringLiteral(".mp4") : QStringLiteral(".png");
  render(file.toStdString());
}

void RenderDialog::render(const std::filesystem::path& out) {
  auto wanted = choices_->order(session_, viewport_);
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
  choices_->setEnabled(!rendering_);
  QString text;
  if (view_.problem) {
    text = textOf(*view_.problem);
  } else if (!view_.ended && !view_.doing.empty()) {
    text = tr("Getting ready: %1…").arg(QString::fromStdString(view_.doing));
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
