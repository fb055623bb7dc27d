#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "ui/panels/number_field.h"

namespace ui {

/// Two times side by side, from and until, or neither: then it is always.
class IntervalField : public QWidget {
  Q_OBJECT

 public:
  using Interval = std::optional<std::array<double, 2>>;

  explicit IntervalField(const NumberFormat& format, QWidget* parent = nullptr);

  NumberField& from() { return *from_; }
  NumberField& until() { return *until_; }
  void setValue(const Interval& value);
  /// Several things are shown that differ.
  void setMixed(bool mixed);

 signals:
  /// The person changed one of the ends; one that is taken away takes the other along.
  void edited(const Interval& value, bool finished);

 private:
  void take(std::size_t end, std::optional<double> value, bool finished);

  Interval value_;
  NumberField* from_;
  NumberField* until_;
};

}  // namespace ui
