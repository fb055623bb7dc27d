#include "modeling/import/lammps_header.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "modeling/text/spelling.h"

namespace modeling {
namespace {

using sim::Problem;

constexpr unsigned kAllBounds = 0b000111;
constexpr unsigned kAllEdges = 0b111000;

/// Counts of what is neither node nor bond: 0 of them is no problem, nor is any number of types.
constexpr std::array<std::string_view, 8> kOthers{"angles",     "dihedrals", "impropers", "crossterms",
                                                  "ellipsoids", "lines",     "triangles", "bodies"};
constexpr std::array<std::string_view, 4> kOtherTypes{"atom", "angle", "dihedral", "improper"};

bool names(std::string_view word, const auto& list) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

sim::Result<bool> countIn(const Token& word, std::uint32_t line, LammpsHeader::Count& count) {
  const std::optional<std::int64_t> value = word.integer();
  if (!value || *value < 0)
    return Problem{std::to_string(word.column), inQuotes(word.text) + " is no count",
                   "give a whole number of at least 0"};
  count = {*value, line};
  return true;
}

sim::Result<bool> otherCount(const std::vector<Token>& words) {
  if (words[0].integer() == 0) return true;
  return Problem{std::to_string(words[1].column),
                 "the file has " + std::string(words[1].text) + ", which nodes and bonds cannot stand for",
                 "write it with atom_style bond"};
}

/// The numbers that a line of the box begins with.
sim::Result<bool> numbersIn(const std::vector<Token>& words, std::size_t count, sim::Vec3& out) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::optional<double> number = words[i].number();
    if (!number)
      return Problem{std::to_string(words[i].column), inQuotes(words[i].text) + " is no finite number",
                     "correct it"};
    out[static_cast<Eigen::Index>(i)] = *number;
  }
  return true;
}

sim::Result<bool> boundsIn(const std::vector<Token>& words, int axis, LammpsHeader& header) {
  sim::Vec3 bounds = sim::Vec3::Zero();
  auto read = numbersIn(words, 2, bounds);
  header.low[axis] = bounds[0];
  header.high[axis] = bounds[1];
  header.stated |= 1U << static_cast<unsigned>(axis);
  return read;
}

sim::Result<bool> edgeIn(const std::vector<Token>& words, int edge, LammpsHeader& header) {
  sim::Vec3 vector = sim::Vec3::Zero();
  auto read = numbersIn(words, 3, vector);
  header.general.edges.col(edge) = vector;
  header.stated |= 8U << static_cast<unsigned>(edge);
  return read;
}

/// A line that says something of the box.
sim::Result<bool> boxLine(const std::vector<Token>& words, LammpsHeader& header) {
  static constexpr std::array<std::string_view, 3> kHigh{"xhi", "yhi", "zhi"};
  static constexpr std::array<std::string_view, 3> kEdge{"avec", "bvec", "cvec"};
  const std::string_view last = words.back().text;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    if (words.size() == 4 && last == kHigh[i]) return boundsIn(words, axis, header);
    if (words.size() == 4 && last == kEdge[i]) return edgeIn(words, axis, header);
  }
  if (words.size() == 6 && last == "yz") return numbersIn(words, 3, header.tilt);
  if (words.size() == 5 && last == "origin") return numbersIn(words, 3, header.general.origin);
  return false;
}

}  // namespace

std::optional<LammpsBox> LammpsHeader::box() const {
  std::optional<LammpsBox> box;
  if ((stated & kAllEdges) == kAllEdges) box = general;
  if ((stated & kAllBounds) == kAllBounds) box = LammpsBox::ofBounds(low, high, tilt);
  return box && box->hasVolume() ? box : std::nullopt;
}

sim::Result<bool> readLammpsHeaderLine(const std::vector<Token>& words, std::uint32_t line,
                                       LammpsHeader& header) {
  if (words.size() < 2) return false;
  const std::string_view second = words[1].text;
  if (words.size() == 2 && second == "atoms") return countIn(words[0], line, header.atoms);
  if (words.size() == 2 && second == "bonds") return countIn(words[0], line, header.bonds);
  if (words.size() == 2 && names(second, kOthers)) return otherCount(words);
  if (words.size() == 3 && words[2].text == "types") {
    LammpsHeader::Count unused;
    if (second == "bond") return countIn(words[0], line, header.bondTypes);
    if (names(second, kOtherTypes)) return countIn(words[0], line, unused);
  }
  if (second == "extra") return true;
  return boxLine(words, header);
}

}  // namespace modeling
