#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace modeling {

/// Where a line of `Atoms` has what we read of it; the rest of it is passed over.
struct LammpsAtomStyle {
  std::string_view name;
  std::string_view form;
  std::size_t words = 6;  ///< without image flags
  std::size_t type = 2;
  std::size_t position = 3;
  std::size_t diameter = 0;  ///< and density behind it; 0: masses are by type
};

/// The first one is meant where none is stated.
inline constexpr std::array<LammpsAtomStyle, 8> kLammpsAtomStyles{
    {{"bond", "id molecule type x y z"},
     {"angle", "id molecule type x y z"},
     {"molecular", "id molecule type x y z"},
     {"full", "id molecule type charge x y z", 7, 2, 4},
     {"atomic", "id type x y z", 5, 1, 2},
     {"charge", "id type charge x y z", 6, 1, 3},
     {"sphere", "id type diameter density x y z", 7, 1, 4, 2},
     {"dipole", "id type charge x y z mux muy muz", 9, 1, 3}}};

}  // namespace modeling
