#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "modeling/text/enum_values.h"

/// What people call the values of enumerations. Each label stands beside its value, and a list that lacks a
/// value does not compile.
namespace modeling {

template <class Choice>
struct ChoiceLabel {
  Choice value;
  std::string_view label;  ///< in English
};

/// Whether each value of the enumeration has exactly one label that is not empty.
template <class Choice, std::size_t kCount>
constexpr bool labelsEachValue(const std::array<ChoiceLabel<Choice>, kCount>& list) {
  if (kCount != kEnumSize<Choice>) return false;
  for (std::size_t i = 0; i < kCount; ++i) {
    if (list[i].label.empty()) return false;
    for (std::size_t j = 0; j < i; ++j) {
      if (list[i].value == list[j].value) return false;
    }
  }
  return true;
}

/// Specialised for each enumeration of the scene: `static constexpr std::array<ChoiceLabel<T>, N> kList`, in
/// the order of menus.
template <class T>
struct ChoiceLabels;

}  // namespace modeling
