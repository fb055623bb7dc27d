#include "modeling/import/shape_keys.h"

#include <cstring>
#include <string>

#include "modeling/import/mesh_text.h"

namespace modeling {
namespace {

using namespace std::string_view_literals;

void take(double weight, ShapeKeys& keys) {
  (weight != 0.0 ? keys.someAreOn : keys.someAreOff) = true;
}

template <class Number>
void takeBinary(std::string_view bytes, ShapeKeys& keys) {
  Number number{};
  if (bytes.size() < sizeof number) return;
  std::memcpy(&number, bytes.data(), sizeof number);
  take(static_cast<double>(number), keys);
}

std::string_view behind(std::string_view text, std::string_view mark, std::size_t& from) {
  from = text.find(mark, from);
  if (from == std::string_view::npos) return {};
  from += mark.size();
  return text.substr(from);
}

}  // namespace

ShapeKeys shapeKeysOfFbx(std::string_view bytes) {
  ShapeKeys keys;
  const bool isBinary = bytes.starts_with("Kaydara FBX Binary");
  // A record of a binary file: the length of its name, its name, the type of its value, the value.
  const std::string_view mark = isBinary ? "\x0d"
                                           "DeformPercent"sv
                                         : "DeformPercent:"sv;
  for (std::size_t from = 0; from < bytes.size();) {
    std::string_view rest = behind(bytes, mark, from);
    if (rest.empty()) break;
    if (!isBinary) {
      if (const auto number = numberOf(nextWord(rest))) take(*number, keys);
    } else if (rest.front() == 'D') {
      takeBinary<double>(rest.substr(1), keys);
    } else if (rest.front() == 'F') {
      takeBinary<float>(rest.substr(1), keys);
    }
  }
  return keys;
}

ShapeKeys shapeKeysOfCollada(std::string_view text) {
  ShapeKeys keys;
  for (std::size_t from = 0; from < text.size();) {
    const std::string_view input = behind(text, "MORPH_WEIGHT", from);
    if (input.empty()) break;
    // The source's name stands on either side of the meaning, within one pair of brackets.
    const std::size_t open = text.rfind('<', from);
    const std::string_view element = text.substr(open, text.find('>', from) - open);
    std::size_t name = element.find("source=");
    if (name == std::string_view::npos || (name = element.find('#', name)) == std::string_view::npos)
      continue;
    const std::string_view id = element.substr(name + 1, element.find_first_of("\"'", name) - name - 1);
    std::size_t at = text.find("id=\"" + std::string(id) + "\"");
    if (at == std::string_view::npos) continue;
    if (behind(text, "<float_array", at).empty() || behind(text, ">", at).empty()) continue;
    std::string_view numbers = text.substr(at, text.find('<', at) - at);
    for (std::string_view word = nextWord(numbers); !word.empty(); word = nextWord(numbers))
      if (const auto number = numberOf(word)) take(*number, keys);
  }
  return keys;
}

}  // namespace modeling
