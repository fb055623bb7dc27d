#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>

#include "modeling/scene/field_info.h"
#include "ui/panels/property_form.h"

/// One row for a value of each type that fields have. `reach` answers the value in an item, or null where the
/// item has none; `standard` is the value that is not given.
namespace ui {

template <class Value>
struct ValueRow {
  RowLabel label;
  modeling::Rule rule;
  modeling::Display display;
  std::function<Value*(modeling::Scene&, const Item&)> reach;
  Value standard;
};

void addRow(PropertyForm& form, const ValueRow<double>& row);
void addRow(PropertyForm& form, const ValueRow<std::optional<double>>& row);
void addRow(PropertyForm& form, const ValueRow<bool>& row);
void addRow(PropertyForm& form, const ValueRow<std::uint64_t>& row);
void addRow(PropertyForm& form, const ValueRow<std::string>& row);
void addRow(PropertyForm& form, const ValueRow<modeling::Vec3>& row);
void addRow(PropertyForm& form, const ValueRow<modeling::Colour>& row);
void addRow(PropertyForm& form, const ValueRow<std::optional<modeling::Colour>>& row);
void addRow(PropertyForm& form, const ValueRow<std::optional<std::array<double, 2>>>& row);
void addRow(PropertyForm& form, const ValueRow<modeling::Rotation>& row);
void addRow(PropertyForm& form, const ValueRow<modeling::Scale>& row);
/// A value that is the same all along; one that varies is left to the handles in the viewport.
void addRow(PropertyForm& form, const ValueRow<modeling::ValueChain>& row);

/// How a number of such a field is shown and what is taken.
NumberFormat formatOf(const modeling::Rule& rule, const modeling::Display& display);

}  // namespace ui
