#include "modeling/import/lammps_data.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>

#include "modeling/import/lammps_atom_style.h"
#include "modeling/import/lammps_checks.h"
#include "modeling/import/lammps_header.h"
#include "modeling/import/lammps_sections.h"
#include "modeling/import/lammps_unwrap.h"
#include "modeling/shapes/resolution.h"
#include "modeling/text/line_tokens.h"
#include "modeling/text/packed_text.h"
#include "modeling/text/spelling.h"

namespace modeling {
namespace {

using sim::Vec3;

using Image = std::array<std::int32_t, 3>;
constexpr std::int64_t kMostBoxes = 1 << 20;  // LAMMPS' own limit is 512, or this

/// Reads one file. Functions return false after noting the problem.
class Reader {
 public:
  Reader(std::string_view text, const std::string& source) : lines_(text), source_(source) {}

  sim::Result<LammpsData> read() {
    lines_.next();  // the first line is a title, whatever it says
    bool more = lines_.next();
    while (more && good()) {
      const bool header = lines_.words().empty() || readHeaderLine();
      if (good()) more = header ? lines_.next() : readSection();
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
    const sim::Result<bool> read = readLammpsHeaderLine(lines_.words(), lines_.line(), header_);
    if (read) return *read;
    const sim::Problem& problem = read.problem();
    fail(lines_.line(), static_cast<std::uint32_t>(std::stoul(problem.place)), problem.what, problem.remedy);
    return true;
  }

  using ReadLine = bool (Reader::*)();
  /// What reads the lines of a section; nothing for one that is not ours.
  std::optional<ReadLine> readerOf(const std::string& name) const {
    if (name == "Masses") return &Reader::readMass;
    if (name == "Atoms") return &Reader::readAtom;
    if (name == "Velocities") return &Reader::readVelocity;
    if (name == "Bonds") return &Reader::readBond;
    if (name.ends_with("Coeffs")) return &Reader::passOver;
    if (name == kLammpsLabelSections[0]) return &Reader::readAtomLabel;
    if (name == kLammpsLabelSections[1]) return &Reader::readBondLabel;
    if (isIn(kLammpsLabelSections, name)) return &Reader::passOver;
    if (isIn(kLammpsOtherSections, name)) return &Reader::refuseLine;
    return std::nullopt;
  }

  /// Reads a section; the reader then stands on the line behind it. False at the end of the text or after a
  /// problem.
  bool readSection() {
    const std::vector<Token> words = lines_.words();
    section_ = lammpsSectionName(words);
    if (section_ == "Atoms" && !takeAtomStyle(words[0])) return false;
    if (section_ == "Atoms") data_.atomsLine = lines_.line();
    const std::optional<ReadLine> readLine = readerOf(section_);
    if (!readLine) {
      return failAt(words[0], "there is no section " + inQuotes(section_) + " in a file of nodes and bonds",
                    didYouMean(section_, {"Masses", "Atoms", "Velocities", "Bonds"}));
    }
    if (*readLine == &Reader::readVelocity || *readLine == &Reader::readBond) ids_.sort();
    while (lines_.next()) {
      if (lines_.words().empty()) continue;
      if (beginsSection(*readLine == &Reader::passOver)) return true;
      if (!(this->**readLine)()) return false;
    }
    return false;
  }

  /// Lines that are passed over may begin with a label.
  bool beginsSection(bool passedOver) const {
    if (passedOver) return readerOf(lammpsSectionName(lines_.words())).has_value();
    return !lines_.words()[0].number() && !isDamagedLammpsLine(lines_.words());
  }
  bool passOver() { return true; }
  bool refuseLine() {
    return failAt(lines_.words()[0],
                  "the file has " + inQuotes(section_) + ", which nodes and bonds cannot stand for",
                  "write it with atom_style bond");
  }

  bool readLabel(std::map<std::string, std::int64_t>& labels) {
    std::int64_t type = 0;
    if (!wordCount({2}, "type label") || !readInteger(0, "the type", type)) return false;
    return labels.emplace(lines_.words()[1].text, type).second ||
           failAt(lines_.words()[1], "this label is given twice", "name types apart");
  }
  bool readAtomLabel() { return readLabel(atomLabels_); }
  bool readBondLabel() { return readLabel(bondLabels_); }

  bool takeAtomStyle(const Token& word) {
    if (data_.atomsLine != 0) return failAt(word, "there is a second section \"Atoms\"", "keep one of them");
    const std::string_view name = lines_.comment();
    const auto known = std::find_if(kLammpsAtomStyles.begin(), kLammpsAtomStyles.end(),
                                    [&](const LammpsAtomStyle& style) { return style.name == name; });
    if (known != kLammpsAtomStyles.end()) style_ = *known;
    return name.empty() || known != kLammpsAtomStyles.end() ||
           failAt(word, "the atoms are of style " + inQuotes(name), "write them with atom_style bond");
  }

  bool wordCount(std::initializer_list<std::size_t> counts, std::string_view form) {
    const std::vector<Token>& words = lines_.words();
    if (std::find(counts.begin(), counts.end(), words.size()) != counts.end()) return true;
    return failAt(words[0], "this line has " + std::to_string(words.size()) + " words",
                  "write " + std::string(form));
  }

  /// By its number or its label.
  bool readType(std::size_t word, const std::map<std::string, std::int64_t>& labels, std::int64_t& out) {
    const auto known = labels.find(std::string(lines_.words()[word].text));
    if (known == labels.end()) return readInteger(word, "the type", out);
    out = known->second;
    return true;
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
    if (!wordCount({2}, "type mass") || !readType(0, atomLabels_, type)) return false;
    const Token& word = lines_.words()[1];
    const std::optional<double> mass = word.number();
    if (!mass || *mass <= 0.0)
      return failAt(word, "the mass is " + inQuotes(word.text), "give a number above 0");
    return masses_.emplace(type, *mass).second ||
           failAt(lines_.words()[0], "this type has a mass already", "keep one");
  }

  bool readAtom() {
    std::int64_t id = 0;
    std::int64_t type = 0;
    Vec3 position = Vec3::Zero();
    Image image{};
    if (ids_.size() >= kMaxLatticeNodes) {
      return failAt(lines_.words()[0], "there are more than " + std::to_string(kMaxLatticeNodes) + " atoms",
                    "use fewer");
    }
    if (!wordCount({style_.words, style_.words + 3}, style_.form) || !readInteger(0, "the id", id) ||
        !readType(style_.type, atomLabels_, type) || !readVector(style_.position, position) ||
        !readImage(image) || !readBall()) {
      return false;
    }
    ids_.add(id);
    atomLines_.push_back(lines_.line());
    types_.push_back(type);
    images_.push_back(image);
    data_.positions.push_back(position);
    return true;
  }

  /// The image flags, if there are any.
  bool readImage(Image& image) {
    const std::vector<Token>& words = lines_.words();
    for (std::size_t i = 0; style_.words + i < words.size(); ++i) {
      const std::optional<std::int64_t> flag = words[style_.words + i].integer();
      if (!flag || *flag < -kMostBoxes || *flag > kMostBoxes) {
        return failAt(words[style_.words + i], "the image flag is " + inQuotes(words[style_.words + i].text),
                      "give a whole number, by how many boxes the atom was moved");
      }
      image[i] = static_cast<std::int32_t>(*flag);
    }
    return true;
  }

  /// The mass of an atom that is a ball; of one without size the density is the mass.
  bool readBall() {
    if (style_.diameter == 0) return true;
    Vec3 ball = Vec3::Zero();  // and the number behind, which readVector() has looked at
    if (!readVector(style_.diameter, ball)) return false;
    const double volume = ball[0] > 0.0 ? std::numbers::pi / 6.0 * ball[0] * ball[0] * ball[0] : 1.0;
    data_.masses.push_back(volume * ball[1]);
    return data_.masses.back() > 0.0 ||
           failAt(lines_.words()[style_.diameter + 1], "the atom has no mass", "give a density above 0");
  }

  bool readVelocity() {
    std::int64_t id = 0;
    Vec3 velocity = Vec3::Zero();
    std::uint32_t node = 0;
    // Balls turn, which nodes do not.
    if (!wordCount({4, 7}, "id vx vy vz") || !readInteger(0, "the id", id) || !readVector(1, velocity) ||
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
    if (!wordCount({4}, "id type node node") || !readInteger(0, "the id", bond.id) ||
        !readType(1, bondLabels_, type) || !readInteger(2, "the node", ends[0]) ||
        !readInteger(3, "the node", ends[1]) || !findNode(2, ends[0], bond.a) ||
        !findNode(3, ends[1], bond.b)) {
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

  bool findNode(std::size_t word, std::int64_t id, std::uint32_t& node) {
    const std::optional<std::uint32_t> found = ids_.nodeOf(id);
    if (!found) {
      return failAt(lines_.words()[word], "there is no atom " + std::to_string(id),
                    "list it in the section \"Atoms\", which must come first");
    }
    node = *found;
    return true;
  }

  bool checkCount(std::string_view what, const LammpsHeader::Count& stated, std::size_t found) {
    if (stated.line != 0 && stated.value == static_cast<std::int64_t>(found)) return true;
    if (stated.line == 0 && found == 0) return true;
    const std::string claim = stated.line == 0 ? "no count" : std::to_string(stated.value);
    return fail(stated.line, 1,
                "the header gives " + claim + " for " + std::string(what) + ", but there are " +
                    std::to_string(found),
                "the file may be cut off; write it again");
  }

  void finish() {
    if (!checkCount("atoms", header_.atoms, data_.positions.size()) ||
        !checkCount("bonds", header_.bonds, data_.bonds.size()))
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
    if (checkIds() && checkBonds() && giveMasses() && unwrap()) checkPlaces();
  }

  /// Positions as if there were no box.
  bool unwrap() {
    const std::optional<LammpsBox> box = header_.box();
    const auto moved =
        std::find_if(images_.begin(), images_.end(), [](const Image& image) { return image != Image{}; });
    if (moved != images_.end() && !box) {
      return fail(atomLines_[static_cast<std::size_t>(moved - images_.begin())], 1,
                  "this atom lies in another image of the box, and the header states no box",
                  "state the box, or write unwrapped positions");
    }
    if (!box) return true;
    for (std::size_t node = 0; node < images_.size(); ++node) {
      const Image& image = images_[node];
      data_.positions[node] += box->edges * Vec3(image[0], image[1], image[2]);
    }
    const sim::Status unwrapped = unwrapBonds(*box, source_, data_);
    if (!unwrapped) problem_ = unwrapped.problem();
    return unwrapped.ok();
  }

  /// A bond needs a direction. Nodes that no bond joins may be in one place, as at a cut.
  void checkPlaces() {
    for (const LammpsBond& bond : data_.bonds) {
      if (data_.positions[bond.a] != data_.positions[bond.b]) continue;
      fail(bond.line, 1,
           "bond " + std::to_string(bond.id) + " joins atoms that are in one place, those of lines " +
               std::to_string(atomLines_[bond.a]) + " and " + std::to_string(atomLines_[bond.b]),
           "move one of them, or make them one atom");
      return;
    }
    const auto two = twoInOnePlace(data_.positions);
    if (!two) return;
    data_.notes.push_back(source_ + ':' + std::to_string(atomLines_[two->second]) +
                          ":1: this atom is in one place with that of line " +
                          std::to_string(atomLines_[two->first]));
  }

  bool checkIds() {
    ids_.sort();
    const auto twice = ids_.givenTwice();
    return !twice || fail(atomLines_[twice->node], 1,
                          "the id " + std::to_string(twice->id) + " is given twice", "number atoms apart");
  }

  bool checkBonds() {
    for (const LammpsBond& bond : data_.bonds) {
      if (header_.bondTypes.line == 0 || bond.type <= header_.bondTypes.value) continue;
      return fail(bond.line, 1,
                  "the header has " + std::to_string(header_.bondTypes.value) +
                      " bond types, this bond is of type " + std::to_string(bond.type),
                  "correct one of the two");
    }
    const std::optional<LammpsBond> second = secondOfPair(data_.bonds);
    return !second || fail(second->line, 1, "these two nodes are bonded already", "keep one bond a pair");
  }

  bool giveMasses() {
    if (style_.diameter != 0) return true;
    for (std::size_t node = 0; node < types_.size(); ++node) {
      const auto mass = masses_.find(types_[node]);
      if (mass == masses_.end()) {
        return fail(atomLines_[node], 1, "atoms of type " + std::to_string(types_[node]) + " have no mass",
                    "add the type to the section \"Masses\"");
      }
      data_.masses.push_back(mass->second);
    }
    return true;
  }

  LineTokens lines_;
  const std::string& source_;
  LammpsData data_;
  LammpsHeader header_;
  LammpsAtomStyle style_ = kLammpsAtomStyles[0];
  std::string section_;  ///< that is being read
  std::map<std::string, std::int64_t> atomLabels_, bondLabels_;
  std::map<std::int64_t, double> masses_;
  LammpsIds ids_;  ///< in file order until the first section that looks them up
  std::vector<std::int64_t> types_;
  std::vector<std::uint32_t> atomLines_;
  std::vector<Image> images_;
  std::size_t velocityCount_ = 0;
  std::optional<sim::Problem> problem_;
};

}  // namespace

sim::Result<LammpsData> parseLammpsData(std::string_view text, const std::string& source) {
  return Reader(text, source).read();
}

sim::Result<LammpsData> loadLammpsData(const std::filesystem::path& file) {
  const sim::Result<std::string> text = readPackedTextFile(file, kLargestLammpsFile);
  if (!text) return text.problem();
  return parseLammpsData(*text, file.string());
}

}  // namespace modeling
