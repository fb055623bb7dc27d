#pragma once

#include <functional>
#include <string>
#include <type_traits>

#include "modeling/scene/scene_fields.h"
#include "modeling/scene/scene_names.h"
#include "ui/panels/property_form.h"

namespace ui {

/// The rows of one struct of the scene. Ranges, help and paths are those of its list of keys
/// (scene_fields.h), so that the panel and the file agree by themselves.
template <class Owner>
class Fieldset {
 public:
  using Scene = modeling::Scene;
  /// Null where the item has no such thing.
  using Place = std::function<Owner*(Scene&, const Item&)>;

  Fieldset(PropertyForm& form, std::string path, Place place)
      : form_(form), path_(std::move(path)), place_(std::move(place)) {}

  NumberField* number(double Owner::*member, const QString& text, Dimension dimension, double step,
                      bool logarithmic = false) {
    NumberFormat format = formatOf(member, dimension, step);
    format.logarithmic = logarithmic;
    return form_.addNumber(
        labelOf(member, text), format,
        [place = place_, member](Scene& scene, const Item& item) -> std::optional<double> {
          Owner* owner = place(scene, item);
          return owner ? std::optional(owner->*member) : std::nullopt;
        },
        [place = place_, member](Scene& scene, const Item& item, const std::optional<double>& value) {
          Owner* owner = place(scene, item);
          if (owner && value) owner->*member = *value;
        },
        Owner{}.*member);
  }

  /// One that may be left to the program, which is shown as `autoText`.
  NumberField* number(std::optional<double> Owner::*member, const QString& text, Dimension dimension,
                      double step, const QString& autoText, bool logarithmic = false) {
    NumberFormat format = formatOf(member, dimension, step);
    format.autoText = autoText;
    format.logarithmic = logarithmic;
    return form_.addNumber(
        labelOf(member, text), format,
        [place = place_, member](Scene& scene, const Item& item) -> std::optional<double> {
          Owner* owner = place(scene, item);
          return owner ? owner->*member : std::nullopt;
        },
        [place = place_, member](Scene& scene, const Item& item, const std::optional<double>& value) {
          if (Owner* owner = place(scene, item)) owner->*member = value;
        },
        std::nullopt);
  }

  VectorField* vector(sim::Vec3 Owner::*member, const QString& text, Dimension dimension, double step) {
    return form_.addVector(
        labelOf(member, text), formatOf(member, dimension, step),
        [place = place_, member](Scene& scene, const Item& item) -> sim::Vec3* {
          Owner* owner = place(scene, item);
          return owner ? &(owner->*member) : nullptr;
        },
        Owner{}.*member);
  }

  QWidget* check(bool Owner::*member, const QString& text) {
    return form_.addCheck(labelOf(member, text),
                          [place = place_, member](Scene& scene, const Item& item) -> bool* {
                            Owner* owner = place(scene, item);
                            return owner ? &(owner->*member) : nullptr;
                          });
  }

  ColourField* colour(modeling::Colour Owner::*member, const QString& text) {
    return form_.addColour(labelOf(member, text),
                           [place = place_, member](Scene& scene, const Item& item) -> modeling::Colour* {
                             Owner* owner = place(scene, item);
                             return owner ? &(owner->*member) : nullptr;
                           });
  }

  /// `names`: what people call the choices, in the order of EnumNames<Choice>::names().
  template <class Choice>
  ChoiceField* choice(Choice Owner::*member, const QString& text, const QStringList& names) {
    using Table = modeling::EnumNames<Choice>;
    std::vector<std::pair<QString, QVariant>> choices;
    const std::vector<std::string> keys = Table::names();
    for (std::size_t i = 0; i < keys.size(); ++i)
      choices.emplace_back(names.value(static_cast<int>(i), QString::fromStdString(keys[i])),
                           static_cast<int>(*Table::find(keys[i])));
    return form_.addChoice(
        labelOf(member, text), choices,
        [place = place_, member](Scene& scene, const Item& item) -> QVariant {
          Owner* owner = place(scene, item);
          return owner ? QVariant(static_cast<int>(owner->*member)) : QVariant();
        },
        [place = place_, member](Scene& scene, const Item& item, const QVariant& data) {
          if (Owner* owner = place(scene, item)) owner->*member = static_cast<Choice>(data.toInt());
        });
  }

  template <class Value>
  RowLabel labelOf(Value Owner::*member, const QString& text) const {
    const modeling::Rule rule = ruleOf(member);
    const auto help = QString::fromUtf8(rule.help.data(), static_cast<qsizetype>(rule.help.size()));
    return {text, help, path_ + "." + std::string(rule.key)};
  }

  template <class Value>
  static modeling::Rule ruleOf(Value Owner::*member) {
    modeling::Rule rule;
    std::apply([&](const auto&... fields) { (take(rule, fields, member), ...); },
               modeling::Fields<Owner>::list());
    return rule;
  }

 private:
  template <class Field, class Value>
  static void take(modeling::Rule& rule, const Field& field, Value Owner::*member) {
    if constexpr (std::is_same_v<decltype(field.member), Value Owner::*>) {
      if (field.member == member) rule = field.rule;
    }
  }

  template <class Value>
  static NumberFormat formatOf(Value Owner::*member, Dimension dimension, double step) {
    const modeling::Rule rule = ruleOf(member);
    NumberFormat format;
    format.dimension = dimension;
    format.step = step;
    constexpr double kUnbounded = 1e300;
    const double scale = rule.angle ? std::numbers::pi / 180.0 : 1.0;
    if (rule.range.least > -kUnbounded) format.least = rule.range.least * scale;
    if (rule.range.most < kUnbounded) format.most = rule.range.most * scale;
    format.leastExcluded = rule.range.leastExcluded;
    return format;
  }

  PropertyForm& form_;
  std::string path_;
  Place place_;
};

}  // namespace ui
