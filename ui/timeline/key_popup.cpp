#include "ui/timeline/key_popup.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QKeyEvent>
#include <algorithm>

#include "ui/document/document.h"
#include "ui/document/track_titles.h"
#include "ui/theme/theme.h"

namespace ui {

KeyPopup::KeyPopup(Document& document, const KeyPlace& place, QWidget* parent)
    : QFrame(parent, Qt::Popup), document_(document), known_(document.scene().tracks), place_(place) {
  setObjectName(QStringLiteral("keyPopup"));
  setAttribute(Qt::WA_DeleteOnClose);
  setFrameShape(QFrame::StyledPanel);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(10, 10, 10, 10);
  form->setSpacing(6);
  const modeling::SceneTrack& found = known_.at(place.track);
  const modeling::SceneTrackKey& shown = found.keys.at(place.key);
  time_ = addField(tr("Time"), shown.time, tr(" s"), 5);
  time_->setMinimum(0.0);
  const sim::Vec3 value = modeling::asVector(shown.value);
  const QString unit = QStringLiteral(" ") + unitText(unitOf(found.target));
  const QString names[] = {tr("X"), tr("Y"), tr("Z")};
  for (std::size_t c = 0; c < componentsOf(found.target); ++c) {
    const bool single = !found.target.isVector();
    QDoubleSpinBox* field =
        addField(single ? tr("Value") : names[c], value[static_cast<Eigen::Index>(c)], unit, 4);
    field->setMinimum(std::max(field->minimum(), leastOf(found.target)));
    values_.push_back(field);
  }
  connect(&document_, &Document::sceneChanged, this, &KeyPopup::followKey);
}

void KeyPopup::followKey() {
  if (place_) place_ = followedKey(known_, document_.scene().tracks, *place_);
  known_ = document_.scene().tracks;
  if (!place_) close();
}

QDoubleSpinBox* KeyPopup::addField(const QString& name, double value, const QString& unit, int decimals) {
  auto* field = new QDoubleSpinBox(this);
  field->setButtonSymbols(QAbstractSpinBox::NoButtons);
  field->setRange(-1e6, 1e6);
  field->setDecimals(decimals);
  field->setSuffix(unit);
  field->setValue(value);
  field->setFont(Theme::numberFont(-0.5));
  field->setAlignment(Qt::AlignRight);
  field->setFixedWidth(130);
  static_cast<QFormLayout*>(layout())->addRow(name, field);
  return field;
}

void KeyPopup::open(const QPoint& globalPosition) {
  adjustSize();
  move(globalPosition + QPoint(10, -height() - 6));
  show();
  values_.front()->setFocus();
  values_.front()->selectAll();
}

void KeyPopup::apply() {
  // It may get a key press between its closing and its end.
  if (!place_) return;
  document_.edit(tr("Change Key"), [&](modeling::Scene& scene) {
    modeling::SceneTrack& edited = scene.tracks.at(place_->track);
    modeling::SceneTrackKey& key = edited.keys.at(place_->key);
    sim::Vec3 value = modeling::asVector(key.value);
    for (std::size_t c = 0; c < values_.size(); ++c) {
      // A number nobody touched keeps the digits that are not shown.
      double& component = value[static_cast<Eigen::Index>(c)];
      if (qAbs(values_[c]->value() - component) > 0.5e-4) component = values_[c]->value();
    }
    key.value = asValue(edited.target, value);
    if (qAbs(time_->value() - key.time) > 0.5e-5) moveKey(edited, place_->key, time_->value());
  });
}

void KeyPopup::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
    apply();
    close();
    return;
  }
  QFrame::keyPressEvent(event);
}

}  // namespace ui
