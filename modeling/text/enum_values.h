#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>

/// How many values an enumeration has, so that a table of them can be checked to leave none out.
namespace modeling {

namespace detail {

/// The compiler's own words for this function name the value, or show a cast where there is none of that
/// number.
template <auto kValue>
constexpr bool hasName() {
  constexpr std::string_view kWords = __PRETTY_FUNCTION__;
  constexpr std::string_view kStart = "kValue = ";
  return kWords[kWords.find(kStart) + kStart.size()] != '(';
}

template <class T, std::size_t kFirst = 0>
constexpr std::size_t countValues() {
  if constexpr (hasName<static_cast<T>(kFirst)>()) {
    return countValues<T, kFirst + 1>();
  } else {
    return kFirst;
  }
}

}  // namespace detail

/// Of an enumeration whose values are numbered from 0 without gaps.
template <class T>
requires std::is_enum_v<T>
inline constexpr std::size_t kEnumSize = detail::countValues<T>();

/// Whether rows of (anything, value) have each of the enumeration's values once.
template <class Row, std::size_t kRows>
constexpr bool namesEachOnce(const std::array<Row, kRows>& rows) {
  using T = std::remove_cv_t<decltype(Row::second)>;
  if (kRows != kEnumSize<T>) return false;
  std::array<bool, kEnumSize<T>> seen{};
  for (const Row& row : rows) {
    const auto value = static_cast<std::size_t>(row.second);
    if (value >= seen.size() || seen[value]) return false;
    seen[value] = true;
  }
  return true;
}

}  // namespace modeling
