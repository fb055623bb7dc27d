#include "ui/panels/value_rows.h"

#include <numbers>

#include "ui/panels/field_rows.h"
#include "ui/panels/interval_field.h"
#include "ui/panels/plain_fields.h"
#include "ui/panels/rotation_rows.h"
#include "ui/panels/vector_field.h"

namespace ui {
namespace {

using modeling::Dimension;
using modeling::Scene;
using MaybeNumber = std::optional<double>;

/// Above this a double cannot tell whole numbers apart.
constexpr double kLargestWhole = 9007199254740992.0;

/// The three numbers of a vector have no room for their unit.
RowLabel withUnit(RowLabel label, Dimension dimension) {
  label.unit = QString::fromUtf8(unitsOf(dimension).front().symbol);
  return label;
}

/// The number, if it is the same all along.
MaybeNumber constantOf(const modeling::ValueChain& chain) {
  if (chain.empty()) return std::nullopt;
  const double first = chain.front()[0];
  const modeling::ValueChain constant(chain.size(), {first, first, first, first});
  return chain == constant ? MaybeNumber(first) : std::nullopt;
}

}  // namespace

NumberFormat formatOf(const modeling::Rule& rule, const modeling::Display& display) {
  NumberFormat format;
  format.dimension = display.dimension;
  format.step = display.step;
  format.logarithmic = display.logarithmic;
  format.autoText = translatedField(display.absent);
  const double scale = rule.angle ? std::numbers::pi / 180.0 : 1.0;
  format.least = rule.range.least * scale;
  format.most = rule.range.most * scale;
  format.gauge = display.gauge;
  return format;
}

void addRow(PropertyForm& form, const ValueRow<double>& row) {
  form.addNumber(
      row.label, formatOf(row.rule, row.display),
      [reach = row.reach](Scene& scene, const Item& item) {
        const double* value = reach(scene, item);
        return value ? MaybeNumber(*value) : std::nullopt;
      },
      [reach = row.reach](Scene& scene, const Item& item, const MaybeNumber& number) {
        double* value = reach(scene, item);
        if (value && number) *value = *number;
      },
      row.standard);
}

void addRow(PropertyForm& form, const ValueRow<std::optional<double>>& row) {
  form.addNumber(
      row.label, formatOf(row.rule, row.display),
      [reach = row.reach](Scene& scene, const Item& item) {
        const MaybeNumber* value = reach(scene, item);
        return value ? *value : std::nullopt;
      },
      [reach = row.reach](Scene& scene, const Item& item, const MaybeNumber& number) {
        if (MaybeNumber* value = reach(scene, item)) *value = number;
      },
      row.standard);
}

void addRow(PropertyForm& form, const ValueRow<bool>& row) {
  form.addCheck(row.label, row.reach);
}

void addRow(PropertyForm& form, const ValueRow<std::uint64_t>& row) {
  NumberFormat format = formatOf(row.rule, row.display);
  format.whole = true;
  format.least = std::max(format.least, 0.0);
  format.most = std::min(format.most, kLargestWhole);
  format.step = 1.0;
  form.addNumber(
      row.label, format,
      [reach = row.reach](Scene& scene, const Item& item) {
        const std::uint64_t* value = reach(scene, item);
        return value ? MaybeNumber(static_cast<double>(*value)) : std::nullopt;
      },
      [reach = row.reach](Scene& scene, const Item& item, const MaybeNumber& number) {
        std::uint64_t* value = reach(scene, item);
        if (value && number) *value = static_cast<std::uint64_t>(*number);
      },
      static_cast<double>(row.standard));
}

void addRow(PropertyForm& form, const ValueRow<std::string>& row) {
  if (!row.display.files.empty()) {
    form.addFile(row.label, QString::fromUtf8(row.display.files.data(), qsizetype(row.display.files.size())),
                 row.reach);
    return;
  }
  form.addText(
      row.label,
      [reach = row.reach](Scene& scene, const Item& item) {
        const std::string* value = reach(scene, item);
        return value ? QString::fromStdString(*value) : QString();
      },
      [reach = row.reach](Scene& scene, const Item& item, const QString& text) {
        if (std::string* value = reach(scene, item)) *value = text.toStdString();
      });
}

void addRow(PropertyForm& form, const ValueRow<modeling::Vec3>& row) {
  form.addVector(withUnit(row.label, row.display.dimension), formatOf(row.rule, row.display), row.reach,
                 row.standard);
}

void addRow(PropertyForm& form, const ValueRow<modeling::Colour>& row) {
  form.addColour(row.label, row.reach);
}

void addRow(PropertyForm& form, const ValueRow<std::optional<modeling::Colour>>& row) {
  form.addColour(row.label, translatedField(row.display.absent), row.reach);
}

void addRow(PropertyForm& form, const ValueRow<std::optional<std::array<double, 2>>>& row) {
  auto* field = new IntervalField(formatOf(row.rule, row.display), &form);
  field->setObjectName(QString::fromStdString(row.label.path));
  form.addRow(row.label, field, [&form, field, reach = row.reach](Scene& scene) {
    const IntervalField::Interval* shown = reach(scene, form.current());
    if (!shown) return;
    field->setValue(*shown);
    for (const Item& item : form.items()) {
      const IntervalField::Interval* other = reach(scene, item);
      if (other && *other != *shown) field->setMixed(true);
    }
  });
  QObject::connect(field, &IntervalField::edited, &form,
                   [&form, row](const IntervalField::Interval& interval, bool finished) {
                     form.apply(
                         row.label.text,
                         [&](Scene& scene, const Item& item) {
                           if (IntervalField::Interval* value = row.reach(scene, item)) *value = interval;
                         },
                         finished);
                   });
}

void addRow(PropertyForm& form, const ValueRow<modeling::Rotation>& row) {
  addRotation(form, withUnit(row.label, row.display.dimension), formatOf(row.rule, row.display), row.reach);
}

void addRow(PropertyForm& form, const ValueRow<modeling::Scale>& row) {
  form.addVector(
      withUnit(row.label, row.display.dimension), formatOf(row.rule, row.display),
      [reach = row.reach](Scene& scene, const Item& item) {
        modeling::Scale* scale = reach(scene, item);
        return scale ? &scale->factors : nullptr;
      },
      row.standard.factors);
}

void addRow(PropertyForm& form, const ValueRow<modeling::ValueChain>& row) {
  NumberFormat format = formatOf(row.rule, row.display);
  format.autoText = PropertyForm::tr("varies");
  form.addNumber(
      row.label, format,
      [reach = row.reach](Scene& scene, const Item& item) {
        const modeling::ValueChain* chain = reach(scene, item);
        return chain ? constantOf(*chain) : std::nullopt;
      },
      [reach = row.reach](Scene& scene, const Item& item, const MaybeNumber& number) {
        modeling::ValueChain* chain = reach(scene, item);
        if (chain && number) *chain = modeling::constantValue(*number);
      },
      constantOf(row.standard));
}

}  // namespace ui
