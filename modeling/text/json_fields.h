#pragma once

#include <numbers>
#include <string_view>
#include <tuple>

#include "modeling/text/dimension.h"

/// Each struct that stands in a file has one list of its fields, Fields<T>::list(). Reading, writing and the
/// schema are made from it (json_codec.h), and so are the tables of docs/formats.md and the forms of the
/// window (scene/field_info.h). A field that is added to the list appears in all of them.
namespace modeling {

/// What a number may be; for vectors, each of their numbers. Every number has bounds: what is far beyond
/// anything that can be built would only fail somewhere else, and later.
struct NumberRange {
  double least = -reachOf(Dimension::number);
  double most = reachOf(Dimension::number);

  /// What is no number is in no range.
  constexpr bool holds(double number) const { return number >= least && number <= most; }
};

/// How a value is to be read: what to call it in messages, and what it may be.
struct Rule {
  std::string_view key;
  std::string_view help;  ///< one sentence without the unit
  bool required = false;
  NumberRange range;   ///< of the number as written
  bool angle = false;  ///< the member is in radians; the file has degrees
};

/// How a value is shown to people.
struct Display {
  std::string_view label;  ///< what stands before the value in a form, in English, without its unit
  Dimension dimension = Dimension::number;
  double step = 0.1;         ///< what one notch of the wheel adds, in the member's unit
  bool logarithmic = false;  ///< the number spans many powers of ten, so that dragging multiplies it
  bool gauge = false;        ///< how far it is between its bounds means something, and is shown
  std::string_view absent;   ///< what it means where there is no value, such as "auto"
  std::string_view present;  ///< what a box to be ticked says that gives a group where there may be none
  std::string_view files;    ///< the value names a file of these patterns, such as "*.data *.lmp"
};

template <class Owner, class Value>
struct Field {
  Value Owner::*member;
  Rule rule;
  Display display;
  /// Whether the value is looked at, given the owner's other values; null: always.
  bool (*counts)(const Owner&) = nullptr;

  // What the number may be.

  constexpr Field required() const {
    return with([](Field& field) { field.rule.required = true; });
  }
  constexpr Field atLeast(double least) const {
    return with([least](Field& field) { field.rule.range.least = least; });
  }
  constexpr Field atMost(double most) const {
    return with([most](Field& field) { field.rule.range.most = most; });
  }
  constexpr Field between(double least, double most) const { return atLeast(least).atMost(most); }
  /// A length of something that is there.
  constexpr Field size(double step) const { return in(Dimension::length, step).atLeast(kSmallestLength); }

  // How it is shown.

  /// Bounds it by what is usual of the dimension, so the range is stated after it.
  constexpr Field in(Dimension dimension, double step) const {
    return with([dimension, step](Field& field) {
      field.display.dimension = dimension;
      field.display.step = step;
      field.rule.range = {-reachOf(dimension), reachOf(dimension)};
    });
  }
  /// Radians in the scene, degrees in its file and in forms, where a notch turns by five of them.
  constexpr Field angle() const {
    Field result = in(Dimension::angle, std::numbers::pi / 36.0);
    result.rule.angle = true;
    return result;
  }
  constexpr Field step(double step) const {
    return with([step](Field& field) { field.display.step = step; });
  }
  constexpr Field gauge() const {
    return with([](Field& field) { field.display.gauge = true; });
  }
  constexpr Field logarithmic() const {
    return with([](Field& field) { field.display.logarithmic = true; });
  }
  constexpr Field absent(std::string_view meaning) const {
    return with([meaning](Field& field) { field.display.absent = meaning; });
  }
  constexpr Field present(std::string_view words) const {
    return with([words](Field& field) { field.display.present = words; });
  }
  constexpr Field file(std::string_view patterns) const {
    return with([patterns](Field& field) { field.display.files = patterns; });
  }
  /// The value is looked at only where `condition` holds.
  constexpr Field where(bool (*condition)(const Owner&)) const {
    return with([condition](Field& field) { field.counts = condition; });
  }

 private:
  template <class Change>
  constexpr Field with(Change change) const {
    Field result = *this;
    change(result);
    return result;
  }
};

/// The key in files, the member it fills, what people call it, and a sentence about it without its unit.
template <class Owner, class Value>
constexpr Field<Owner, Value> field(std::string_view key, Value Owner::*member, std::string_view label,
                                    std::string_view help) {
  Display display;
  display.label = label;
  return {member, {key, help, false, {}, false}, display, nullptr};
}

/// A key that files of older versions may hold and that means nothing any more. It is read over with a note.
struct RetiredKey {
  std::string_view key;
  std::string_view since;  ///< when the program stopped looking at it
  std::string_view why;    ///< what holds now, as the end of a sentence
};

/// Specialised for each struct: `static constexpr auto list()` yields a tuple of Field. Where keys were
/// retired, `static constexpr std::array<RetiredKey, N> kRetired` lists them.
template <class T>
struct Fields;

/// Specialised for each enumeration: names() yields all as strings; find(name) the value, if it is one;
/// nameOf(value).
template <class T>
struct EnumNames;

/// Specialised for each variant whose alternatives a key tells apart: `kTag`, the key; `kNames`, one name an
/// alternative, in the variant's order.
template <class T>
struct VariantNames;

}  // namespace modeling
