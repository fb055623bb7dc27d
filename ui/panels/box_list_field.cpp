#include "ui/panels/box_list_field.h"

#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/document/part_boxes.h"
#include "ui/panels/vector_field.h"
#include "ui/theme/theme.h"

namespace ui {

BoxListField::BoxListField(QWidget* parent) : QWidget(parent) {
  column_ = new QVBoxLayout(this);
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(6);
  auto* add = new QPushButton(Theme::icon(QStringLiteral("add")), tr("Hold a Region"), this);
  add->setObjectName(QStringLiteral("add-hold"));
  add->setToolTip(tr("Adds a box, in the part's own coordinates: nodes inside stay where they are"));
  column_->addWidget(add);
  connect(add, &QPushButton::clicked, this, &BoxListField::add);
}

void BoxListField::show(const modeling::Part& part) {
  boxes_ = part.hold;
  extent_ = boxOf(part.shape);
  while (rows_.size() > boxes_.size()) {
    rows_.back().widget->hide();
    rows_.back().widget->deleteLater();
    rows_.pop_back();
  }
  while (rows_.size() < boxes_.size()) addRow();
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    rows_[i].least->setValue(boxes_[i].min);
    rows_[i].most->setValue(boxes_[i].max);
  }
}

void BoxListField::addRow() {
  const std::size_t index = rows_.size();
  NumberFormat format;
  format.dimension = Dimension::length;
  format.step = 0.1;
  auto* widget = new QWidget(this);
  auto* grid = new QGridLayout(widget);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(3);
  Row row{widget, new VectorField(format, widget), new VectorField(format, widget)};
  auto* remove = new QToolButton(widget);
  remove->setIcon(Theme::icon(QStringLiteral("remove")));
  remove->setToolTip(tr("Let go of this region"));
  grid->addWidget(new QLabel(tr("From, cm"), widget), 0, 0);
  grid->addWidget(row.least, 0, 1);
  grid->addWidget(remove, 0, 2);
  grid->addWidget(new QLabel(tr("To, cm"), widget), 1, 0);
  grid->addWidget(row.most, 1, 1);
  grid->setColumnMinimumWidth(0, 64);
  grid->setColumnStretch(1, 1);
  column_->insertWidget(static_cast<int>(index), widget);
  rows_.push_back(row);
  connect(row.least, &VectorField::edited, this,
          [this, index](std::size_t axis, double value, bool finished) {
            modeling::Box& box = boxes_[index];
            const auto number = static_cast<Eigen::Index>(axis);
            box.min[number] = value;
            box.max[number] = std::max(box.max[number], value);
            emit edited(boxes_, finished);
          });
  connect(row.most, &VectorField::edited, this, [this, index](std::size_t axis, double value, bool finished) {
    modeling::Box& box = boxes_[index];
    const auto number = static_cast<Eigen::Index>(axis);
    box.max[number] = value;
    box.min[number] = std::min(box.min[number], value);
    emit edited(boxes_, finished);
  });
  connect(remove, &QToolButton::clicked, this, [this, index] {
    boxes_.erase(boxes_.begin() + static_cast<std::ptrdiff_t>(index));
    emit edited(boxes_, true);
  });
}

void BoxListField::add() {
  // The lowest fifth: what one would nail down first.
  modeling::Box box{sim::Vec3::Constant(-1.0), sim::Vec3::Constant(1.0)};
  if (!extent_.isEmpty()) {
    box = {extent_.min(), extent_.max()};
    box.max.z() = box.min.z() + 0.2 * extent_.sizes().z();
  }
  boxes_.push_back(box);
  emit edited(boxes_, true);
}

}  // namespace ui
