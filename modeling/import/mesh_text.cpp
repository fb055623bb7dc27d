#include "modeling/import/mesh_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <regex>

namespace modeling {
namespace {

using sim::Problem;
using namespace std::string_view_literals;

bool isBlank(char letter) {
  return letter == ' ' || letter == '\t' || letter == '\r' || letter == '\n' || letter == '\v' ||
         letter == '\f';
}

struct UnitWord {
  const char* words;  ///< a pattern
  double centimetres;
};
constexpr std::array<UnitWord, 5> kUnitWords{{{"mm|milli(?:met(?:er|re))?s?", 0.1},
                                              {"cm|centi(?:met(?:er|re))?s?", 1.0},
                                              {"m|met(?:er|re)s?", 100.0},
                                              {"in|inch(?:es)?", 2.54},
                                              {"ft|foot|feet", 30.48}}};
/// No statement of a unit is longer.
constexpr std::size_t kLongestStatement = 400;

std::optional<double> unitIn(const std::string& text) {
  for (const UnitWord& unit : kUnitWords) {
    const std::string word = "(?:" + std::string(unit.words) + ")\\b";
    if (std::regex_search(text, std::regex("\\bunits?\\b[\\s:=(\"']*(?:(?:are|is|in)\\s+)?" + word)) ||
        std::regex_search(text, std::regex("\\buses\\s+" + word + "\\s+as\\s+units\\b")) ||
        std::regex_search(text, std::regex("^\\s*smithereens\\b[^,]*,\\s*" + word)))
      return unit.centimetres;
  }
  return std::nullopt;
}

struct Signature {
  std::string_view bytes;
  const char* what;
  const char* remedy;
  std::string_view endings;  ///< of names that rightly begin so
};

const char* const kUnpack = "unpack it first";
const char* const kRename = "give the file the ending of its format, or export it anew";
constexpr const char* kUtf8 = "save it as plain text or UTF-8, or export it anew";

const std::vector<Signature>& signatures() {
  static const std::vector<Signature> kSignatures{
      {"\x1f\x8b"sv, "this file is packed by gzip", kUnpack, ""},
      {"PK\x03\x04"sv, "this file is a zip archive", kUnpack, ""},
      {"7z\xbc\xaf\x27\x1c"sv, "this file is packed by 7-Zip", kUnpack, ""},
      {"BZh"sv, "this file is packed by bzip2", kUnpack, ""},
      {"\xfd"
       "7zXZ"sv,
       "this file is packed by xz", kUnpack, ""},
      {"\x28\xb5\x2f\xfd"sv, "this file is packed by zstd", kUnpack, ""},
      {"Rar!"sv, "this file is packed by RAR", kUnpack, ""},
      {"\xff\xfe"sv, "this file is text of UTF-16", kUtf8, ""},
      {"\xfe\xff"sv, "this file is text of UTF-16", kUtf8, ""},
      {"BLENDER"sv, "this is a file of Blender", "export a mesh from Blender", ""},
      {"version https://git-lfs"sv, "this is only the pointer of Git LFS to a file",
       "fetch the file itself: git lfs pull", ""},
      {"glTF"sv, "this is a binary glTF file, whatever its name says", kRename, ".glb.gltf"},
      {"Kaydara FBX"sv, "this is an FBX file, whatever its name says", kRename, ".fbx"},
      {"ply\n"sv, "this is a PLY file, whatever its name says", kRename, ".ply"},
      {"ply\r"sv, "this is a PLY file, whatever its name says", kRename, ".ply"},
      {"<!doctype html"sv, "this is a page of the web and no mesh", "download the mesh itself", ""},
      {"<html"sv, "this is a page of the web and no mesh", "download the mesh itself", ""},
  };
  return kSignatures;
}

/// Every other byte of the beginning is zero, as of Latin letters in UTF-16 without a mark.
bool isTwoByteText(std::string_view bytes) {
  static constexpr std::size_t kLetters = 16;
  if (bytes.size() < 2 * kLetters) return false;
  for (const std::size_t first : {0U, 1U}) {
    bool isText = true;
    for (std::size_t i = 0; i < kLetters && isText; ++i) {
      const auto letter = static_cast<unsigned char>(bytes[2 * i + first]);
      isText = bytes[2 * i + 1 - first] == '\0' && letter >= 9 && letter < 127;
    }
    if (isText) return true;
  }
  return false;
}

}  // namespace

bool MeshLines::next() {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find_first_of("\r\n");
  line_ = rest_.substr(0, end);
  std::size_t length = end == std::string_view::npos ? rest_.size() : end + 1;
  if (end != std::string_view::npos && rest_[end] == '\r' && end + 1 < rest_.size() && rest_[end + 1] == '\n')
    ++length;
  rest_.remove_prefix(length);
  ++number_;
  return true;
}

std::string_view nextWord(std::string_view& text) {
  std::size_t begin = 0;
  while (begin < text.size() && isBlank(text[begin])) ++begin;
  std::size_t end = begin;
  while (end < text.size() && !isBlank(text[end])) ++end;
  const std::string_view word = text.substr(begin, end - begin);
  text.remove_prefix(end);
  return word;
}

std::optional<double> numberOf(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  double number = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (end != word.data() + word.size() || word.empty()) return std::nullopt;
  // Out of range is too small as often as too large: zero is right for the one, and the other is found later.
  if (error == std::errc::result_out_of_range)
    return word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos
               ? 0.0
               : std::numeric_limits<double>::infinity();
  return error == std::errc() ? std::optional(number) : std::nullopt;
}

std::optional<std::int64_t> integerOf(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || word.empty() || end != word.data() + word.size()) return std::nullopt;
  return number;
}

sim::Result<sim::Vec3> pointOf(std::string_view& text, const std::string& place) {
  sim::Vec3 point = sim::Vec3::Zero();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const std::string_view word = nextWord(text);
    const auto number = numberOf(word);
    if (word.empty())
      return Problem{"", place + ": this corner has fewer than three coordinates", "export it anew"};
    if (!number) {
      const bool hasComma = word.find(',') != std::string_view::npos;
      return Problem{"", place + ": \"" + std::string(word.substr(0, 40)) + "\" is no number",
                     hasComma ? "export it with points in its numbers, not commas" : "export it anew"};
    }
    point[axis] = *number;
  }
  return point;
}

std::string inLowerCase(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return lower;
}

void takeStatement(std::string_view comment, RawMesh& raw) {
  std::string text = inLowerCase(comment.substr(0, kLongestStatement));
  std::replace_if(
      text.begin(), text.end(), [](char letter) { return letter == '\0' || letter == '_'; }, ' ');
  if (raw.unitSaid == Statement::nobody) {
    if (const auto unit = unitIn(text)) raw.stateUnit(*unit, Statement::theFile);
  }
  static const std::regex kUp("\\b([xyz])[ -]?up\\b|\\bup ?axis\\b[\\s:=+]*([xyz])\\b");
  std::smatch found;
  if (raw.axesSaid == Statement::nobody && std::regex_search(text, found, kUp))
    raw.stateUp(found[found[1].matched ? 1 : 2].str().front(), Statement::theFile);
}

std::optional<Problem> whatElse(std::string_view bytes, std::string_view ending) {
  const std::string_view begin = bytes.substr(0, std::min<std::size_t>(bytes.size(), 64));
  std::string_view text = begin;
  while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
  const std::string lower = inLowerCase(text);
  for (const Signature& known : signatures()) {
    const bool isIt =
        begin.starts_with(known.bytes) || (known.bytes.front() == '<' && lower.starts_with(known.bytes));
    const bool isRight = !known.endings.empty() && known.endings.find(ending) != std::string_view::npos;
    if (isIt && !isRight) return Problem{"", known.what, known.remedy};
  }
  if (isTwoByteText(bytes)) return Problem{"", "this file is text of UTF-16", kUtf8};
  if (bytes.empty()) return Problem{"", "this file is empty", "export it anew"};
  return std::nullopt;
}

}  // namespace modeling
