#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "modeling/text/line_tokens.h"

namespace modeling {

/// Names of sections of data files. Those of labels, of atoms and bonds first, which we read.
inline constexpr std::array<std::string_view, 5> kLammpsLabelSections{
    "Atom Type Labels", "Bond Type Labels", "Angle Type Labels", "Dihedral Type Labels",
    "Improper Type Labels"};
/// What nodes and bonds cannot stand for.
inline constexpr std::array<std::string_view, 7> kLammpsOtherSections{
    "Angles", "Dihedrals", "Impropers", "Ellipsoids", "Lines", "Triangles", "Bodies"};

template <class Names>
bool isIn(const Names& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

inline std::string lammpsSectionName(const std::vector<Token>& words) {
  std::string name(words[0].text);
  for (std::size_t i = 1; i < words.size() && i < 4; ++i) name.append(1, ' ').append(words[i].text);
  return name;
}

/// A line of a section starts with a number; the name of the next section has no digits in it.
inline bool isDamagedLammpsLine(const std::vector<Token>& words) {
  return words[0].text.find_first_of("0123456789") != std::string_view::npos ||
         (words.size() > 1 && words[1].number().has_value());
}

}  // namespace modeling
