#include "ui/viewport/view_choices.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QSlider>

#include "ui/viewport/viewport.h"

namespace ui {
namespace {

/// Farther apart than twice the distance from the middle, shards only get small.
constexpr int kMostPercent = 200;

template <class Change>
void changeSettings(Viewport& viewport, const Change& change) {
  ViewSettings settings = viewport.viewSettings();
  change(settings);
  viewport.setViewSettings(settings);
}

}  // namespace

ViewChoices::ViewChoices(Viewport& viewport) : QFrame(&viewport, Qt::Popup), viewport_(viewport) {
  setObjectName(QStringLiteral("viewChoices"));
  setFrameShape(QFrame::StyledPanel);
  form_ = new QFormLayout(this);
  form_->setContentsMargins(14, 12, 14, 14);
  form_->setVerticalSpacing(7);
  addHeading(tr("Body"));
  addCheck(tr("Surface"), tr("The faces of whole cells"), &ViewSettings::surface);
  addCheck(tr("X-ray"), tr("Look through the surface"), &ViewSettings::xray);
  addCheck(tr("Broken faces in the inside colour"), tr("Tells what broke from what was always outside"),
           &ViewSettings::insideColour);
  addCheck(tr("Level surface"), tr("Where the potential of the nodes has one value; for small bodies"),
           &ViewSettings::levelSurface);
  addColouring();
  addHeading(tr("Lattice"));
  addCheck(tr("Nodes"), tr("Every node as a ball"), &ViewSettings::nodes);
  addCheck(tr("Bonds by strain"), tr("Every bond, coloured by how near it is to breaking"),
           &ViewSettings::bonds);
  addCheck(tr("Broken bonds too"), tr("Where bonds are shown: also those that broke"),
           &ViewSettings::brokenBonds);
  addCheck(tr("Glue"), tr("The pairs of nodes that are glued, at rest, and the bonds that join two parts"),
           &ViewSettings::gluePairs);
  addIsolated();
  addExplode();
  addHeading(tr("Surroundings"));
  addCheck(tr("Grid"), tr("1, 10 and 100 cm"), &ViewSettings::grid);
  addCheck(tr("Shadows"), tr("Of the key light"), &ViewSettings::shadows);
  addCheck(tr("Ambient occlusion"), tr("Corners and undersides darker, as they see less of the sky"),
           &ViewSettings::occlusion);
  addCheck(tr("Invisible colliders as outlines"), {}, &ViewSettings::invisibleColliders);
}

void ViewChoices::addHeading(const QString& text) {
  auto* label = new QLabel(QStringLiteral("<b>%1</b>").arg(text), this);
  if (form_->rowCount() > 0) label->setContentsMargins(0, 6, 0, 0);
  form_->addRow(label);
}

void ViewChoices::addCheck(const QString& text, const QString& tip, bool ViewSettings::*what) {
  auto* box = new QCheckBox(text, this);
  box->setToolTip(tip);
  box->setChecked(viewport_.viewSettings().*what);
  connect(box, &QCheckBox::toggled, this, [this, what](bool on) {
    changeSettings(viewport_, [&](ViewSettings& settings) { settings.*what = on; });
  });
  form_->addRow(box);
}

void ViewChoices::addColouring() {
  auto* box = new QComboBox(this);
  box->addItems({tr("Material"), tr("Fragments"), tr("Quality of cells")});
  box->setCurrentIndex(static_cast<int>(viewport_.viewSettings().colouring));
  connect(box, &QComboBox::currentIndexChanged, this, [this](int index) {
    changeSettings(viewport_,
                   [&](ViewSettings& settings) { settings.colouring = static_cast<Colouring>(index); });
  });
  form_->addRow(tr("Colour"), box);
}

void ViewChoices::addIsolated() {
  auto* box = new QComboBox(this);
  box->addItems({tr("Shards"), tr("Tetrahedra"), tr("Balls"), tr("Given to neighbours")});
  box->setToolTip(
      tr("Nodes that nothing holds any more: shards that fill what their cells filled, or what stands "
         "for them, or their material stays with the fragments beside them"));
  box->setCurrentIndex(static_cast<int>(viewport_.viewSettings().isolated));
  connect(box, &QComboBox::currentIndexChanged, this, [this](int index) {
    changeSettings(viewport_,
                   [&](ViewSettings& settings) { settings.isolated = static_cast<IsolatedNodes>(index); });
  });
  form_->addRow(tr("Loose nodes"), box);
}

void ViewChoices::addExplode() {
  auto* slider = new QSlider(Qt::Horizontal, this);
  slider->setRange(0, kMostPercent);
  slider->setPageStep(20);
  slider->setMinimumWidth(130);
  slider->setToolTip(tr("Moves fragments away from the middle of the body they came from"));
  slider->setValue(static_cast<int>(std::lround(100.0 * viewport_.viewSettings().explode)));
  connect(slider, &QSlider::valueChanged, this, [this](int percent) {
    changeSettings(viewport_, [&](ViewSettings& settings) { settings.explode = percent / 100.0; });
  });
  form_->addRow(tr("Exploded"), slider);
}

}  // namespace ui
