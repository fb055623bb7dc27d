#include "ui/editors/render_choices.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QPointer>
#include <numbers>

#include "ui/panels/number_field.h"
#include "ui/session/session.h"
#include "ui/viewport/viewport.h"

namespace ui {
namespace {

enum class What { moment, allFrames };
enum class From { viewport, scene };
enum class LitBy { studioLamps, image };
using modeling::BackdropKind;
using modeling::GroundKind;
using modeling::PictureSurface;

/// One of the things to choose from. Without a value it is as the scene has it.
template <class Value>
struct Choice {
  QString text;
  std::optional<Value> value;
};

template <class Value>
QComboBox* combo(const QString& name, std::initializer_list<Choice<Value>> choices, QWidget* parent) {
  auto* made = new QComboBox(parent);
  made->setObjectName(name);
  for (const Choice<Value>& choice : choices)
    made->addItem(choice.text, choice.value ? QVariant(static_cast<int>(*choice.value)) : QVariant());
  return made;
}

template <class Value>
std::optional<Value> chosenIn(const QComboBox& combo) {
  const QVariant data = combo.currentData();
  if (!data.isValid()) return std::nullopt;
  return static_cast<Value>(data.toInt());
}

NumberField* number(const QString& name, const NumberFormat& format, double value, const QString& tip,
                    QWidget* parent) {
  auto* field = new NumberField(format, parent);
  field->setObjectName(name);
  field->setValue(value);
  field->setDefault(value);
  field->setToolTip(tip);
  return field;
}

NumberFormat whole(double least, double most) {
  NumberFormat format;
  format.least = least;
  format.most = most;
  format.whole = true;
  format.step = 1.0;
  return format;
}

NumberFormat fractions(double most) {
  NumberFormat format;
  format.least = 0.0;
  format.most = most;
  format.step = 0.05;
  return format;
}

int wholeIn(const NumberField& field) {
  return static_cast<int>(field.value().value_or(1.0));
}

Camera cameraOf(const modeling::Camera& camera) {
  return {camera.position, camera.target, camera.fieldOfView * std::numbers::pi / 180.0, camera.aperture,
          camera.focus.value_or(0.0)};
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

RenderChoices::RenderChoices(QWidget* parent) : QWidget(parent) {
  // Made in the order in which Tab goes through them.
  auto* form = new QFormLayout(this);
  form->setContentsMargins(0, 0, 0, 0);
  what_ =
      combo<What>(QStringLiteral("render-what"),
                  {{tr("This moment"), What::moment}, {tr("All frames of the take"), What::allFrames}}, this);
  camera_ =
      combo<From>(QStringLiteral("render-camera"),
                  {{tr("As in the viewport"), From::viewport}, {tr("Of the scene"), From::scene}}, this);
  form->addRow(tr("Picture of"), what_);
  form->addRow(tr("Camera"), camera_);
  addNumbers(*form);
  addLooks(*form);
  sixteenBit_ = new QCheckBox(tr("16 bit a channel"), this);
  sixteenBit_->setToolTip(tr("Of PNG files: for those who go on working with the picture"));
  form->addRow(QString(), sixteenBit_);
  setFixedWidth(290);
  for (QComboBox* box : {what_, camera_, looseNodes_, surface_, ground_, backdrop_, light_})
    connect(box, &QComboBox::currentIndexChanged, this, &RenderChoices::changed);
  for (NumberField* field : {width_, height_, samples_, aperture_, shutter_})
    connect(field, &NumberField::edited, this, &RenderChoices::changed);
}

void RenderChoices::addNumbers(QFormLayout& form) {
  width_ = number(QStringLiteral("render-width"), whole(16, 8192), 1280, tr("Pixels"), this);
  height_ = number(QStringLiteral("render-height"), whole(16, 8192), 720, tr("Pixels"), this);
  samples_ = number(QStringLiteral("render-samples"), whole(1, 65536), 64,
                    tr("Paths a pixel: four times as many halve the noise"), this);
  aperture_ = number(QStringLiteral("render-aperture"), fractions(100), 0,
                     tr("Diameter of the lens, cm: what is not as far as the target is blurred"), this);
  shutter_ = number(QStringLiteral("render-shutter"), fractions(1), 0,
                    tr("Share of a frame's time for which it is open: what moves is blurred"), this);
  form.addRow(tr("Width"), width_);
  form.addRow(tr("Height"), height_);
  form.addRow(tr("Samples"), samples_);
  form.addRow(tr("Aperture, cm"), aperture_);
  form.addRow(tr("Shutter"), shutter_);
}

void RenderChoices::addLooks(QFormLayout& form) {
  using Loose = sim::LooseNodes;
  looseNodes_ = combo<Loose>(QStringLiteral("render-loose"),
                             {{tr("Shards"), Loose::shards},
                              {tr("Tetrahedra"), Loose::tetrahedra},
                              {tr("Balls"), Loose::spheres},
                              {tr("Given to neighbours"), Loose::givenToNeighbours}},
                             this);
  looseNodes_->setToolTip(tr("How nodes are drawn that nothing holds any more"));
  const QString asScene = tr("As in the scene");
  surface_ = combo<PictureSurface>(QStringLiteral("render-surface"),
                                   {{asScene, {}},
                                    {tr("Of the cells"), PictureSurface::cells},
                                    {tr("Level surface"), PictureSurface::level}},
                                   this);
  ground_ = combo<GroundKind>(QStringLiteral("render-ground"),
                              {{asScene, {}},
                               {tr("Studio floor"), GroundKind::studio},
                               {tr("None"), GroundKind::none},
                               {tr("Plain"), GroundKind::plain},
                               {tr("Checker"), GroundKind::checker},
                               {tr("Wood"), GroundKind::wood},
                               {tr("Shadows only"), GroundKind::shadow}},
                              this);
  backdrop_ = combo<BackdropKind>(QStringLiteral("render-backdrop"),
                                  {{asScene, {}},
                                   {tr("Studio"), BackdropKind::studio},
                                   {tr("Colour"), BackdropKind::colour},
                                   {tr("Gradient"), BackdropKind::gradient},
                                   {tr("Environment"), BackdropKind::environment}},
                                  this);
  light_ = combo<LitBy>(
      QStringLiteral("render-light"),
      {{asScene, {}}, {tr("Studio lamps"), LitBy::studioLamps}, {tr("From an image…"), LitBy::image}}, this);
  light_->setToolTip(tr("An image of all around: OpenEXR, Radiance .hdr or PNG"));
  connect(light_, &QComboBox::activated, this, [this] {
    if (chosenIn<LitBy>(*light_) == LitBy::image) askForEnvironment();
  });
  form.addRow(tr("Loose nodes"), looseNodes_);
  form.addRow(tr("Surface"), surface_);
  form.addRow(tr("Ground"), ground_);
  form.addRow(tr("Backdrop"), backdrop_);
  form.addRow(tr("Light"), light_);
}

void RenderChoices::askForEnvironment() {
  const QPointer<RenderChoices> self(this);
  const QString file = QFileDialog::getOpenFileName(window()->parentWidget(), tr("Image of all around"),
                                                    environment_, tr("Images (*.exr *.hdr *.png)"));
  if (!self) return;
  if (!file.isEmpty()) environment_ = file;
  if (environment_.isEmpty()) light_->setCurrentIndex(0);
  emit changed();
}

modeling::PictureStyle RenderChoices::styleFrom(modeling::PictureStyle style) const {
  style.surface = chosenIn<PictureSurface>(*surface_).value_or(style.surface);
  style.ground.kind = chosenIn<GroundKind>(*ground_).value_or(style.ground.kind);
  style.backdrop.kind = chosenIn<BackdropKind>(*backdrop_).value_or(style.backdrop.kind);
  const std::optional<LitBy> light = chosenIn<LitBy>(*light_);
  if (light == LitBy::studioLamps) style.environment.image.clear();
  if (light == LitBy::image) style.environment.image = environment_.toStdString();
  return style;
}

bool RenderChoices::wantsAllFrames() const {
  return chosenIn<What>(*what_) == What::allFrames;
}

bool RenderChoices::wantsViewportCamera() const {
  return chosenIn<From>(*camera_) == From::viewport;
}

std::optional<PictureJob::Order> RenderChoices::order(Session& session, const Viewport& viewport) const {
  const Shown& shown = session.shown();
  const auto take = session.takes().current();
  if (!shown.network || !shown.moment) return std::nullopt;
  PictureJob::Order order;
  if (wantsAllFrames() && take) {
    const std::shared_ptr<Footage>& footage = session.takes()[*take].footage;
    if (footage->frameCount() == 0) return std::nullopt;
    order.frames = framesOfFootage(footage);
    order.last = footage->frameCount() - 1;
  } else if (const auto awaited = session.awaitedFrame()) {
    // Chosen already, and still on its way to the screen.
    order.frames = framesOfFootage(awaited->footage);
    order.first = order.last = awaited->frame;
  } else {
    order.frames = framesOfMoment(shown);
  }
  if (!order.frames.network) return std::nullopt;
  order.framesPerSecond = order.frames.framesPerSecond;
  order.frames.folder = session.document().folder();
  order.frames.scene.view.picture = styleFrom(order.frames.scene.view.picture);
  if (wantsViewportCamera()) order.camera = cameraOf(viewport.camera().asScene());
  order.choices.looseNodes = chosenIn<sim::LooseNodes>(*looseNodes_).value_or(order.choices.looseNodes);
  order.choices.shutter = shutter_->value().value_or(0.0);
  if (const double aperture = aperture_->value().value_or(0.0); aperture > 0.0)
    order.choices.aperture = aperture;
  order.settings.width = wholeIn(*width_);
  order.settings.height = wholeIn(*height_);
  order.settings.samples = wholeIn(*samples_);
  order.depth = sixteenBit_->isChecked() ? PngDepth::sixteenBit : PngDepth::eightBit;
  return order;
}

}  // namespace ui
