#pragma once

#include <QWidget>
#include <array>

#include "sim/base/types.h"
#include "ui/panels/number_field.h"

namespace ui {

/// Three number fields side by side, marked with the colours of the axes.
class VectorField : public QWidget {
  Q_OBJECT

 public:
  explicit VectorField(const NumberFormat& format, QWidget* parent = nullptr);

  NumberField& field(std::size_t axis) { return *fields_[axis]; }
  void setValue(const sim::Vec3& value);
  void setDefault(const sim::Vec3& value);

 signals:
  /// The person changed one of the numbers; of several things the other two may differ.
  void edited(std::size_t axis, double value, bool finished);

 private:
  void showStripes();

  std::array<NumberField*, 3> fields_{};
};

}  // namespace ui
