#include "ui/panels/key_table.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>

#include "modeling/scene/scene_ranges.h"
#include "ui/panels/number_field.h"
#include "ui/theme/theme.h"

namespace ui {
namespace {

constexpr int kRemoveColumn = 4;

Dimension dimensionOf(modeling::TrackUnit unit) {
  switch (unit) {
    case modeling::TrackUnit::acceleration:
      return Dimension::acceleration;
    case modeling::TrackUnit::length:
      return Dimension::length;
    case modeling::TrackUnit::degrees:
      return Dimension::degrees;
    case modeling::TrackUnit::factor:
      break;
  }
  return Dimension::number;
}

double stepOf(modeling::TrackUnit unit) {
  switch (unit) {
    case modeling::TrackUnit::acceleration:
      return 50.0;
    case modeling::TrackUnit::degrees:
      return 5.0;
    case modeling::TrackUnit::length:
      return 0.5;
    case modeling::TrackUnit::factor:
      break;
  }
  return 0.1;
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
  if (track.target != track_.target || rows_.empty() || rows_.size() > track.keys.size()) clearRows();
  track_ = track;
  if (rows_.empty()) {
    grid_->addWidget(new QLabel(tr("Time"), this), 0, 0);
    grid_->addWidget(new QLabel(tr("Value"), this), 0, 1);
  }
  while (rows_.size() < track_.keys.size()) addRow();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i].time->setValue(track_.keys[i].time);
    const sim::Vec3 value = modeling::asVector(track_.keys[i].value);
    for (std::size_t c = 0; c < rows_[i].values.size(); ++c)
      rows_[i].values[c]->setValue(value[static_cast<Eigen::Index>(c)]);
    rows_[i].remove->setEnabled(track_.keys.size() > 1);
  }
}

void KeyTable::addRow() {
  const std::size_t index = rows_.size();
  const int line = static_cast<int>(index) + 1;
  NumberFormat time;
  time.dimension = Dimension::time;
  time.least = 0.0;
  time.most = modeling::keyTimeRange().most;
  time.step = 0.05;
  Row row;
  row.time = new NumberField(time, this);
  grid_->addWidget(row.time, line, 0);
  connect(row.time, &NumberField::edited, this, [this, index](std::optional<double> value, bool finished) {
    if (value) takeTime(index, *value, finished);
  });
  NumberFormat format;
  const modeling::TrackUnit unit = unitOf(track_.target);
  format.dimension = dimensionOf(unit);
  format.step = stepOf(unit);
  format.unitShown = !track_.target.isVector();
  format.least = leastOf(track_.target);
  format.most = mostOf(track_.target);
  const std::size_t components = componentsOf(track_.target);
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
    if (index >= track_.keys.size() || track_.keys.size() < 2) return;
    track_.keys.erase(track_.keys.begin() + static_cast<std::ptrdiff_t>(index));
    emit edited(track_.keys, true);
  });
  rows_.push_back(std::move(row));
}

void KeyTable::takeTime(std::size_t row, double time, bool finished) {
  // What was typed beside a key that is gone.
  if (row >= track_.keys.size()) return;
  moveKey(track_, row, time);
  emit edited(track_.keys, finished);
  if (row < rows_.size() && row < track_.keys.size()) rows_[row].time->setValue(track_.keys[row].time);
}

void KeyTable::takeValue(std::size_t row, std::size_t component, double value, bool finished) {
  if (row >= track_.keys.size()) return;
  sim::Vec3 changed = modeling::asVector(track_.keys[row].value);
  changed[static_cast<Eigen::Index>(component)] = value;
  track_.keys[row].value = asValue(track_.target, changed);
  emit edited(track_.keys, finished);
}

void KeyTable::addKey() {
  constexpr double kAfterLast = 0.1;  // s
  if (track_.keys.empty()) return;
  const modeling::SceneTrackKey last = track_.keys.back();
  modeling::addKey(track_, last.time + kAfterLast, last.value);
  emit edited(track_.keys, true);
}

}  // namespace ui
