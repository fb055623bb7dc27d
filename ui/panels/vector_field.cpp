#include "ui/panels/vector_field.h"

#include <QHBoxLayout>

#include "ui/theme/theme.h"

namespace ui {

VectorField::VectorField(const NumberFormat& format, QWidget* parent) : QWidget(parent) {
  NumberFormat plain = format;
  plain.unitShown = false;
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(3);
  const std::array<QString, 3> names{QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    fields_[axis] = new NumberField(plain, this);
    fields_[axis]->setAccessibleName(names[axis]);
    row->addWidget(fields_[axis], 1);
    connect(fields_[axis], &NumberField::edited, this,
            [this, axis](std::optional<double> value, bool finished) {
              if (value) emit edited(axis, *value, finished);
            });
  }
  showStripes();
  connect(&Theme::instance(), &Theme::changed, this, &VectorField::showStripes);
}

void VectorField::showStripes() {
  const Colours& colours = Theme::instance().colours();
  fields_[0]->setStripe(colours.axisX);
  fields_[1]->setStripe(colours.axisY);
  fields_[2]->setStripe(colours.axisZ);
}

void VectorField::setValue(const sim::Vec3& value) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    fields_[axis]->setValue(value[static_cast<Eigen::Index>(axis)]);
}

void VectorField::setDefault(const sim::Vec3& value) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    fields_[axis]->setDefault(value[static_cast<Eigen::Index>(axis)]);
}

}  // namespace ui
