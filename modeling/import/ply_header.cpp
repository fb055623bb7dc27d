#include "modeling/import/ply_header.h"

#include <algorithm>
#include <array>

#include "modeling/import/mesh_text.h"

namespace modeling {
namespace {

using sim::Problem;
using sim::Status;

struct TypeName {
  std::string_view name, other;
  std::size_t size;
};
/// In the order of PlyType. Files have either set of names.
constexpr std::array<TypeName, 8> kTypes{{{"char", "int8", 1},
                                          {"uchar", "uint8", 1},
                                          {"short", "int16", 2},
                                          {"ushort", "uint16", 2},
                                          {"int", "int32", 4},
                                          {"uint", "uint32", 4},
                                          {"float", "float32", 4},
                                          {"double", "float64", 8}}};

std::optional<PlyType> typeOf(std::string_view word) {
  for (std::size_t i = 0; i < kTypes.size(); ++i)
    if (word == kTypes[i].name || word == kTypes[i].other) return static_cast<PlyType>(i);
  return std::nullopt;
}

Problem wrong(const std::string& place, const std::string& what) {
  return {"", place + ": " + what, "export it anew"};
}

Status takeFormat(std::string_view rest, const std::string& place, PlyHeader& header) {
  const std::string_view word = nextWord(rest);
  if (word == "ascii") {
    header.format = PlyFormat::text;
  } else if (word == "binary_little_endian") {
    header.format = PlyFormat::littleEndian;
  } else if (word == "binary_big_endian") {
    header.format = PlyFormat::bigEndian;
  } else {
    return wrong(place, "there is no format \"" + std::string(word.substr(0, 40)) + "\" of PLY");
  }
  return sim::Done{};
}

Status takeElement(std::string_view rest, const std::string& place, PlyHeader& header) {
  PlyElement element;
  element.name = nextWord(rest);
  const auto count = integerOf(nextWord(rest));
  if (element.name.empty() || !count || *count < 0)
    return wrong(place, "this element has no name or no count");
  element.count = static_cast<std::uint64_t>(*count);
  header.elements.push_back(std::move(element));
  return sim::Done{};
}

Status takeProperty(std::string_view rest, const std::string& place, PlyHeader& header) {
  if (header.elements.empty()) return wrong(place, "this property is of no element");
  PlyProperty property;
  std::string_view word = nextWord(rest);
  if (word == "list") {
    property.listOf = typeOf(nextWord(rest));
    if (!property.listOf) return wrong(place, "the length of this list has no known type");
    word = nextWord(rest);
  }
  const auto type = typeOf(word);
  property.name = nextWord(rest);
  if (!type || property.name.empty()) return wrong(place, "this property has no known type or no name");
  property.type = *type;
  header.elements.back().properties.push_back(std::move(property));
  return sim::Done{};
}

}  // namespace

std::size_t sizeOf(PlyType type) {
  return kTypes[static_cast<std::size_t>(type)].size;
}

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
  const auto found = std::find_if(properties.begin(), properties.end(),
                                  [&](const PlyProperty& one) { return one.name == property; });
  return found == properties.end() ? std::nullopt : std::optional<std::size_t>(found - properties.begin());
}

sim::Result<PlyHeader> readPlyHeader(std::string_view bytes, RawMesh& raw) {
  // All lines end as the first does: a number behind the head may begin with the byte of a line's end.
  const std::size_t end = bytes.find_first_of("\r\n");
  const bool isPair = end != std::string_view::npos && bytes.substr(end).starts_with("\r\n");
  const std::string_view ending = end == std::string_view::npos ? "\n" : bytes.substr(end, isPair ? 2 : 1);
  if (inLowerCase(bytes.substr(0, end)) != "ply")
    return Problem{"", "this is no PLY: it does not begin with \"ply\"", "export it anew"};
  PlyHeader header;
  bool hasFormat = false;
  for (std::uint64_t number = 1; !bytes.empty(); ++number) {
    const std::size_t length = bytes.find(ending);
    std::string_view rest = bytes.substr(0, length);
    bytes.remove_prefix(length == std::string_view::npos ? bytes.size() : length + ending.size());
    const std::string place = "line " + std::to_string(number);
    const std::string_view key = nextWord(rest);
    Status status = sim::Done{};
    hasFormat = hasFormat || key == "format";
    if (key == "format") status = takeFormat(rest, place, header);
    if (key == "element") status = takeElement(rest, place, header);
    if (key == "property") status = takeProperty(rest, place, header);
    if (key == "comment" || key == "obj_info") takeStatement(rest, raw);
    if (!status) return status.problem();
    header.numbers = bytes;
    if (key == "end_header" && hasFormat) return header;
    if (key == "end_header") return wrong(place, "the head ends before it states a format");
  }
  return Problem{"", "this file is cut short: its head has no end", "copy or export it anew"};
}

}  // namespace modeling
