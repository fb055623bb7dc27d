#pragma once

#include <QString>
#include <optional>
#include <span>

#include "modeling/text/dimension.h"

/// What people type into number fields: numbers with units and arithmetic.
namespace ui {

/// A number's value is in the base unit of its dimension, which is the scene's.
using modeling::Dimension;

struct Unit {
  const char* symbol = "";  ///< UTF-8, as it is shown
  double inBase = 1.0;      ///< base units in one of it
};

/// All units that may be typed, the one usually shown first. Some stand there twice, in another spelling.
std::span<const Unit> unitsOf(Dimension dimension);
/// The unit in which a value is easy to read: GPa for a stiff material, kPa for a jelly.
const Unit& unitFor(Dimension dimension, double value);

/// What a text amounts to, or why it is not a quantity.
struct Reading {
  std::optional<double> value;  ///< in base units; absent: see error
  qsizetype errorAt = 0;        ///< place in the text, counted from 0
  QString error;                ///< one sentence without a full stop
};

/// Reads a sum of products of numbers, pi, parentheses and powers (^), such as "2*3 mm", "(3+4)/2",
/// "1 m + 2 in" or "pi/2 rad". A unit counts for the whole product before it, so that "1/2 in" is half an
/// inch; a result, or a summand, without a unit is in `assumed`.
Reading readQuantity(const QString& text, Dimension dimension, const Unit& assumed);

/// The number in that unit, with as many digits as say it to about one in 10^`digits`, without zeros at the
/// end.
QString numberText(double value, const Unit& unit, int digits = 6);
/// With the unit, as in "8.5 cm".
QString quantityText(double value, Dimension dimension, int digits = 6);

}  // namespace ui
