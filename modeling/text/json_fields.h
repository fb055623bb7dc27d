#pragma once

#include <limits>
#include <string_view>
#include <tuple>

/// Each struct that stands in a file has one list of its keys, Fields<T>::list(). Reading, writing and the
/// schema are all made from it (json_codec.h), so they cannot disagree.
namespace modeling {

/// What a number may be; for vectors, each of their numbers.
struct NumberRange {
  double least = -std::numeric_limits<double>::max();
  double most = std::numeric_limits<double>::max();
  bool leastExcluded = false;
};

/// How a value is to be read: what to call it in messages, and what it may be.
struct Rule {
  std::string_view key;
  std::string_view help;  ///< one sentence with the unit, for the schema
  bool required = false;
  NumberRange range;   ///< of the number as written
  bool angle = false;  ///< the member is in radians; the file has degrees
};

template <class Owner, class Value>
struct Field {
  Value Owner::*member;
  Rule rule;

  constexpr Field required() const {
    Field result = *this;
    result.rule.required = true;
    return result;
  }
  constexpr Field atLeast(double least) const {
    Field result = *this;
    result.rule.range.least = least;
    return result;
  }
  constexpr Field angle() const {
    Field result = *this;
    result.rule.angle = true;
    return result;
  }
  constexpr Field above(double least) const {
    Field result = atLeast(least);
    result.rule.range.leastExcluded = true;
    return result;
  }
  constexpr Field atMost(double most) const {
    Field result = *this;
    result.rule.range.most = most;
    return result;
  }
};

/// A key, the member it fills, and a sentence about it.
template <class Owner, class Value>
constexpr Field<Owner, Value> field(std::string_view key, Value Owner::*member, std::string_view help) {
  return {member, {key, help, false, {}, false}};
}

/// Specialised for each struct: `static constexpr auto list()` yields a tuple of Field.
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
