#include "ui/panels/key_table.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>

#include "ui/panels/number_field.h"
#include "ui/theme/theme.h"

namespace ui {
namespace {

constexpr int kRemoveColumn = 4;

Dimension dimensionOf(const modeling::TargetName& target) {
  switch (target.target) {
    case sim::TrackTarget::gravity:
      return Dimension::acceleration;
    case sim::TrackTarget::colliderPosition:
      return Dimension::length;
    case sim::TrackTarget::colliderRotation:
      return Dimension::degrees;
    default:
      return Dimension::number;
  }
}

double stepOf(const modeling::TargetName& target) {
  switch (target.target) {
    case sim::TrackTarget::gravity:
      return 50.0;
    case sim::TrackTarget::colliderRotation:
      return 5.0;
    case sim::TrackTarget::colliderPosition:
      return 0.5;
    default:
      return 0.1;
  }
}

double componentOf(const modeling::SceneTrackKey& key, std::size_t component) {
  if (const auto* number = std::get_if<double>(&key.value)) return *number;
  return std::get<sim::Vec3>(key.value)[static_cast<Eigen::Index>(component)];
}

}  // namespace

KeyTable::KeyTable(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  grid_ = new QGridLayout;
  grid_->setHorizontalSpacing(3);
  grid_->setVerticalSpacing(3);
  for (int i = 0; i < kRemoveColumn; ++i) grid_->setColumnStretch(i, 1);
  column->addLayout(grid_);
  auto* add = new QPushButton(Theme::icon(QStringLiteral("add")), tr("Add Key"), this);
  add->setToolTip(tr("Adds a key after the last one"));
  column->addWidget(add);
  connect(add, &QPushButton::clicked, this, &KeyTable::addKey);
}

void KeyTable::clearRows() {
  while (QLayoutItem* item = grid_->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();
    delete item;
  }
  rows_.clear();
}

void KeyTable::show(const modeling::SceneTrack& track) {
  if (track.target != target_ || rows_.empty() || rows_.size() > track.keys.size()) clearRows();
  keys_ = track.keys;
  target_ = track.target;
  if (rows_.empty()) {
    grid_->addWidget(new QLabel(tr("Time"), this), 0, 0);
    grid_->addWidget(new QLabel(tr("Value"), this), 0, 1);
  }
  while (rows_.size() < keys_.size()) addRow();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i].time->setValue(keys_[i].time);
    for (std::size_t c = 0; c < rows_[i].values.size(); ++c)
      rows_[i].values[c]->setValue(componentOf(keys_[i], c));
    rows_[i].remove->setEnabled(keys_.size() > 1);
  }
}

void KeyTable::addRow() {
  const std::size_t index = rows_.size();
  const int line = static_cast<int>(index) + 1;
  NumberFormat time;
  time.dimension = Dimension::time;
  time.least = 0.0;
  time.step = 0.05;
  Row row;
  row.time = new NumberField(time, this);
  grid_->addWidget(row.time, line, 0);
  connect(row.time, &NumberField::edited, this, [this, index](std::optional<double> value, bool finished) {
    if (value) takeTime(index, *value, finished);
  });
  NumberFormat format;
  format.dimension = dimensionOf(target_);
  format.step = stepOf(target_);
  format.unitShown = !target_.isVector();
  if (!target_.isVector() && target_.target != sim::TrackTarget::gravityScale) format.least = 0.0;
  const std::size_t components = target_.isVector() ? 3 : 1;
  for (std::size_t c = 0; c < components; ++c) {
    auto* field = new NumberField(format, this);
    grid_->addWidget(field, line, static_cast<int>(c) + 1, 1, components == 1 ? 3 : 1);
    connect(field, &NumberField::edited, this, [this, index, c](std::optional<double> value, bool finished) {
      if (value) takeValue(index, c, *value, finished);
    });
    row.values.push_back(field);
  }
  row.remove = new QToolButton(this);
  row.remove->setIcon(Theme::icon(QStringLiteral("remove")));
  row.remove->setToolTip(tr("Remove this key"));
  grid_->addWidget(row.remove, line, kRemoveColumn);
  connect(row.remove, &QToolButton::clicked, this, [this, index] {
    keys_.erase(keys_.begin() + static_cast<std::ptrdiff_t>(index));
    emit edited(keys_, true);
  });
  rows_.push_back(std::move(row));
}

void KeyTable::takeTime(std::size_t row, double time, bool finished) {
  // Between its neighbours: keys that pass each other would change places under the hand.
  constexpr double kApart = 1e-4;
  if (row > 0) time = std::max(time, keys_[row - 1].time + kApart);
  if (row + 1 < keys_.size()) time = std::min(time, keys_[row + 1].time - kApart);
  keys_[row].time = time;
  emit edited(keys_, finished);
  rows_[row].time->setValue(time);
}

void KeyTable::takeValue(std::size_t row, std::size_t component, double value, bool finished) {
  if (auto* number = std::get_if<double>(&keys_[row].value)) {
    *number = value;
  } else {
    std::get<sim::Vec3>(keys_[row].value)[static_cast<Eigen::Index>(component)] = value;
  }
  emit edited(keys_, finished);
}

void KeyTable::addKey() {
  modeling::SceneTrackKey key;
  if (!keys_.empty()) key = keys_.back();
  if (!keys_.empty()) key.time += 0.1;
  keys_.push_back(key);
  emit edited(keys_, true);
}

}  // namespace ui
