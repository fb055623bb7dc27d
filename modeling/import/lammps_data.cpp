#include "modeling/import/lammps_data.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "modeling/shapes/resolution.h"
#include "modeling/text/line_tokens.h"
#include "modeling/text/spelling.h"
#include "modeling/text/text_file.h"

namespace modeling {
namespace {

using sim::Vec3;

struct Count {
  std::int64_t value = 0;
  std::uint32_t line = 0;  ///< 0: not stated
};

struct AtomId {
  std::int64_t id = 0;
  std::uint32_t node = 0;
};

/// Reads one file. Functions return false after noting the problem.
class Reader {
 public:
  Reader(std::string_view text, const std::string& source) : lines_(text), source_(source) {}

  sim::Result<LammpsData> read() {
    lines_.next();  // the first line is a title, whatever it says
    bool more = lines_.next();
    while (more && good()) {
      if (!lines_.words().empty() && !readHeaderLine()) {
        if (good()) more = readSection();
        continue;
      }
      more = lines_.next();
    }
    if (good()) finish();
    if (problem_) return *problem_;
    return std::move(data_);
  }

 private:
  bool good() const { return !problem_; }

  bool fail(std::uint32_t line, std::uint32_t column, std::string what, std::string remedy) {
    const std::string place =
        source_ + ':' + std::to_string(std::max(line, 1U)) + ':' + std::to_string(column);
    if (!problem_) problem_ = sim::Problem{place, std::move(what), std::move(remedy)};
    return false;
  }
  bool failAt(const Token& token, std::string what, std::string remedy) {
    return fail(lines_.line(), token.column, std::move(what), std::move(remedy));
  }

  /// True when the line was one of the header's.
  bool readHeaderLine() {
    const std::vector<Token>& words = lines_.words();
    const auto is = [&](std::size_t word, std::string_view text) {
      return word < words.size() && words[word].text == text;
    };
    if (words.size() == 2 && is(1, "atoms")) return readCount(atoms_);
    if (words.size() == 2 && is(1, "bonds")) return readCount(bonds_);
    if (words.size() == 3 && is(1, "atom") && is(2, "types")) return readCount(atomTypes_);
    if (words.size() == 3 && is(1, "bond") && is(2, "types")) return readCount(bondTypes_);
    const std::string_view last = words.back().text;
    return (words.size() == 4 && (last == "xhi" || last == "yhi" || last == "zhi")) || is(1, "extra") ||
           (words.size() == 6 && last == "yz") || readOtherCount(words);
  }

  bool readCount(Count& count) {
    const Token& word = lines_.words()[0];
    const std::optional<std::int64_t> value = word.integer();
    if (!value || *value < 0) {
      return failAt(word, inQuotes(word.text) + " is no count", "give a whole number of at least 0");
    }
    count = {*value, lines_.line()};
    return true;
  }

  /// "0 angles" and the like say that there are none; anything else we could not honour.
  bool readOtherCount(const std::vector<Token>& words) {
    constexpr std::array<std::string_view, 9> kOthers{"angles",     "dihedrals", "impropers",
                                                      "ellipsoids", "lines",     "triangles",
                                                      "bodies",     "angle",     "dihedral"};
    if (words.size() < 2 || std::find(kOthers.begin(), kOthers.end(), words[1].text) == kOthers.end())
      return false;
    if (words[0].integer() == 0) return true;
    return failAt(words[1],
                  "the file has " + std::string(words[1].text) + ", which nodes and bonds cannot stand for",
                  "write it with atom_style bond");
  }

  /// Reads a section; the reader then stands on the line behind it. False at the end of the text or after a
  /// problem.
  bool readSection() {
    const std::vector<Token> words = lines_.words();
    std::string name(words[0].text);
    for (std::size_t i = 1; i < words.size() && i < 4; ++i) name.append(1, ' ').append(words[i].text);
    if (name == "Atoms" && !checkAtomStyle(words[0])) return false;
    if (name == "Atoms") data_.atomsLine = lines_.line();
    const bool coefficients = words.back().text == "Coeffs";
    bool (Reader::*readLine)() = nullptr;
    if (name == "Masses") readLine = &Reader::readMass;
    if (name == "Atoms") readLine = &Reader::readAtom;
    if (name == "Velocities") readLine = &Reader::readVelocity;
    if (name == "Bonds") readLine = &Reader::readBond;
    if (readLine == nullptr && !coefficients) {
      return failAt(words[0], "there is no section " + inQuotes(name) + " in a file of nodes and bonds",
                    didYouMean(name, {"Masses", "Atoms", "Velocities", "Bonds"}));
    }
    if (readLine == &Reader::readVelocity || readLine == &Reader::readBond) sortIds();
    while (lines_.next()) {
      if (lines_.words().empty()) continue;
      if (!lines_.words()[0].number() && !isDamagedNumber(lines_.words())) return true;
      if (readLine != nullptr && !(this->*readLine)()) return false;
    }
    return false;
  }

  /// A line of a section starts with a number; the name of the next section has no digits in it.
  static bool isDamagedNumber(const std::vector<Token>& words) {
    return words[0].text.find_first_of("0123456789") != std::string_view::npos ||
           (words.size() > 1 && words[1].number().has_value());
  }

  bool checkAtomStyle(const Token& word) {
    if (data_.atomsLine != 0) return failAt(word, "there is a second section \"Atoms\"", "keep one of them");
    const std::string_view style = lines_.comment();
    return style.empty() || style == "bond" ||
           failAt(word, "the atoms are of style " + inQuotes(style), "write them with atom_style bond");
  }

  bool wordCount(std::size_t least, std::string_view form) {
    const std::vector<Token>& words = lines_.words();
    if (words.size() == least || (least == 6 && words.size() == 9)) return true;
    return failAt(words[0], "this line has " + std::to_string(words.size()) + " words",
                  "write " + std::string(form));
  }

  bool readInteger(std::size_t word, std::string_view what, std::int64_t& out) {
    const Token& token = lines_.words()[word];
    const std::optional<std::int64_t> value = token.integer();
    if (!value || *value < 1) {
      return failAt(token, std::string(what) + " is " + inQuotes(token.text),
                    "give a whole number from 1 on");
    }
    out = *value;
    return true;
  }

  bool readVector(std::size_t firstWord, Vec3& out) {
    for (int axis = 0; axis < 3; ++axis) {
      const Token& token = lines_.words()[firstWord + static_cast<std::size_t>(axis)];
      const std::optional<double> value = token.number();
      if (!value) return failAt(token, inQuotes(token.text) + " is no finite number", "correct it");
      out[axis] = *value;
    }
    return true;
  }

  bool readMass() {
    std::int64_t type = 0;
    if (!wordCount(2, "type mass") || !readInteger(0, "the type", type)) return false;
    const Token& word = lines_.words()[1];
    const std::optional<double> mass = word.number();
    if (!mass || *mass <= 0.0)
      return failAt(word, "the mass is " + inQuotes(word.text), "give a number above 0");
    return masses_.emplace(type, *mass).second ||
           failAt(lines_.words()[0], "this type has a mass already", "keep one");
  }

  bool readAtom() {
    AtomId atom{0, static_cast<std::uint32_t>(ids_.size())};
    std::int64_t type = 0;
    Vec3 position = Vec3::Zero();
    if (ids_.size() >= kMaxLatticeNodes) {
      return failAt(lines_.words()[0], "there are more than " + std::to_string(kMaxLatticeNodes) + " atoms",
                    "use fewer");
    }
    if (!wordCount(6, "id molecule type x y z") || !readInteger(0, "the id", atom.id) ||
        !readInteger(2, "the type", type) || !readVector(3, position)) {
      return false;
    }
    for (std::size_t word = 6; word < lines_.words().size(); ++word) {
      if (lines_.words()[word].integer() != 0) {
        return failAt(lines_.words()[word], "this atom lies in another image of the box",
                      "write unwrapped positions");
      }
    }
    ids_.push_back(atom);
    atomLines_.push_back(lines_.line());
    types_.push_back(type);
    data_.positions.push_back(position);
    return true;
  }

  bool readVelocity() {
    std::int64_t id = 0;
    Vec3 velocity = Vec3::Zero();
    std::uint32_t node = 0;
    if (!wordCount(4, "id vx vy vz") || !readInteger(0, "the id", id) || !readVector(1, velocity) ||
        !findNode(0, id, node)) {
      return false;
    }
    data_.velocities.resize(data_.positions.size(), Vec3::Zero());
    data_.velocities[node] = velocity;
    ++velocityCount_;
    return true;
  }

  bool readBond() {
    std::int64_t type = 0;
    std::array<std::int64_t, 2> ends{};
    LammpsBond bond;
    bond.line = lines_.line();
    if (!wordCount(4, "id type node node") || !readInteger(1, "the type", type) ||
        !readInteger(2, "the node", ends[0]) || !readInteger(3, "the node", ends[1]) ||
        !findNode(2, ends[0], bond.a) || !findNode(3, ends[1], bond.b)) {
      return false;
    }
    if (bond.a == bond.b)
      return failAt(lines_.words()[3], "this bond joins a node to itself", "name two nodes");
    if (type > std::numeric_limits<std::uint16_t>::max()) {
      return failAt(lines_.words()[1], "the type is " + std::to_string(type), "keep types below 65536");
    }
    bond.type = static_cast<int>(type);
    data_.bonds.push_back(bond);
    return true;
  }

  void sortIds() {
    std::sort(ids_.begin(), ids_.end(),
              [](const AtomId& a, const AtomId& b) { return a.id != b.id ? a.id < b.id : a.node < b.node; });
  }

  bool findNode(std::size_t word, std::int64_t id, std::uint32_t& node) {
    const auto found = std::lower_bound(ids_.begin(), ids_.end(), id,
                                        [](const AtomId& a, std::int64_t b) { return a.id < b; });
    if (found == ids_.end() || found->id != id) {
      return failAt(lines_.words()[word], "there is no atom " + std::to_string(id),
                    "list it in the section \"Atoms\", which must come first");
    }
    node = found->node;
    return true;
  }

  bool checkCount(std::string_view what, const Count& stated, std::size_t found) {
    if (stated.line != 0 && stated.value == static_cast<std::int64_t>(found)) return true;
    if (stated.line == 0 && found == 0) return true;
    const std::string claim = stated.line == 0 ? "no count" : std::to_string(stated.value);
    return fail(stated.line, 1,
                "the header gives " + claim + " for " + std::string(what) + ", but there are " +
                    std::to_string(found),
                "the file may be cut off; write it again");
  }

  void finish() {
    if (!checkCount("atoms", atoms_, data_.positions.size()) ||
        !checkCount("bonds", bonds_, data_.bonds.size()))
      return;
    if (data_.positions.empty()) {
      fail(1, 1, "there are no atoms in this file", "give a LAMMPS data file with a section \"Atoms\"");
      return;
    }
    if (!data_.velocities.empty() && velocityCount_ != data_.positions.size()) {
      fail(lines_.line(), 1, "there are " + std::to_string(velocityCount_) + " velocities",
           "give one an atom");
      return;
    }
    if (checkIds() && checkBonds()) giveMasses();
  }

  bool checkIds() {
    sortIds();
    const auto twice = std::adjacent_find(ids_.begin(), ids_.end(),
                                          [](const AtomId& a, const AtomId& b) { return a.id == b.id; });
    return twice == ids_.end() ||
           fail(atomLines_[std::next(twice)->node], 1,
                "the id " + std::to_string(twice->id) + " is given twice", "number atoms apart");
  }

  bool checkBonds() {
    for (const LammpsBond& bond : data_.bonds) {
      if (bondTypes_.line == 0 || bond.type <= bondTypes_.value) continue;
      return fail(bond.line, 1,
                  "the header has " + std::to_string(bondTypes_.value) +
                      " bond types, this bond is of type " + std::to_string(bond.type),
                  "correct one of the two");
    }
    const auto pairOf = [](const LammpsBond& bond) {
      return std::uint64_t{std::min(bond.a, bond.b)} << 32U | std::max(bond.a, bond.b);
    };
    std::vector<std::uint64_t> pairs;
    for (const LammpsBond& bond : data_.bonds) pairs.push_back(pairOf(bond));
    std::sort(pairs.begin(), pairs.end());
    const auto twice = std::adjacent_find(pairs.begin(), pairs.end());
    if (twice == pairs.end()) return true;
    const auto second = std::find_if(data_.bonds.rbegin(), data_.bonds.rend(),
                                     [&](const LammpsBond& bond) { return pairOf(bond) == *twice; });
    return fail(second->line, 1, "these two nodes are bonded already", "keep one bond a pair");
  }

  void giveMasses() {
    for (std::size_t node = 0; node < types_.size(); ++node) {
      const auto mass = masses_.find(types_[node]);
      if (mass == masses_.end()) {
        fail(atomLines_[node], 1, "atoms of type " + std::to_string(types_[node]) + " have no mass",
             "add the type to the section \"Masses\"");
        return;
      }
      data_.masses.push_back(mass->second);
    }
  }

  LineTokens lines_;
  const std::string& source_;
  LammpsData data_;
  Count atoms_;
  Count bonds_;
  Count atomTypes_;
  Count bondTypes_;
  std::map<std::int64_t, double> masses_;
  std::vector<AtomId> ids_;  ///< in file order until the first section that looks them up
  std::vector<std::int64_t> types_;
  std::vector<std::uint32_t> atomLines_;
  std::size_t velocityCount_ = 0;
  std::optional<sim::Problem> problem_;
};

}  // namespace

sim::Result<LammpsData> parseLammpsData(std::string_view text, const std::string& source) {
  return Reader(text, source).read();
}

sim::Result<LammpsData> loadLammpsData(const std::filesystem::path& file) {
  const sim::Result<std::string> text = readTextFile(file, kLargestLammpsFile);
  if (!text) return text.problem();
  return parseLammpsData(*text, file.string());
}

}  // namespace modeling
