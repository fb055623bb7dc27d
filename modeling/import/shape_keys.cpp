#include "modeling/import/shape_keys.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "modeling/import/mesh_text.h"

namespace modeling {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kKind = "SubDeformer"sv;

template <class Number>
std::optional<double> binaryNumber(std::string_view bytes) {
  Number number{};
  if (bytes.size() < sizeof number) return std::nullopt;
  std::memcpy(&number, bytes.data(), sizeof number);
  return static_cast<double>(number);
}

/// The text behind the mark, which is looked for from `from` on; that moves to it. Empty: it is not there.
std::string_view behind(std::string_view text, std::string_view mark, std::size_t& from) {
  from = text.find(mark, from);
  if (from == std::string_view::npos) return {};
  from += mark.size();
  return text.substr(from);
}

/// The number of a record: in binary files it has a type before it.
std::optional<double> recordNumber(std::string_view rest, bool isBinary) {
  if (!isBinary) return numberOf(nextWord(rest));
  if (rest.starts_with('D')) return binaryNumber<double>(rest.substr(1));
  return rest.starts_with('F') ? binaryNumber<float>(rest.substr(1)) : std::nullopt;
}

/// Of the key whose record stands before `end`: in text "SubDeformer::NAME", in bytes a length, NAME, two
/// bytes and the kind.
std::string keyNameBefore(std::string_view bytes, std::size_t end, bool isBinary) {
  const std::size_t kind = bytes.rfind(kKind, end);
  if (kind == std::string_view::npos) return "";
  if (!isBinary) {
    const std::size_t begin = kind + kKind.size() + 2;
    return std::string(bytes.substr(begin, bytes.find('"', begin) - begin));
  }
  static constexpr std::size_t kLongestName = 1024;
  for (std::size_t length = 0; length <= kLongestName && kind >= length + 7; ++length) {
    std::uint32_t stated = 0;
    std::memcpy(&stated, bytes.data() + kind - 2 - length - sizeof stated, sizeof stated);
    if (stated == length + 2 + kKind.size()) return std::string(bytes.substr(kind - 2 - length, length));
  }
  return "";
}

/// The numbers of the source that an element, in which `at` is, names.
std::vector<double> sourceNumbers(std::string_view text, std::size_t at) {
  std::vector<double> numbers;
  const std::size_t open = text.rfind('<', at);
  const std::string_view element = text.substr(open, text.find('>', at) - open);
  std::size_t name = element.find("source=");
  if (name == std::string_view::npos || (name = element.find('#', name)) == std::string_view::npos)
    return numbers;
  const std::string_view id = element.substr(name + 1, element.find_first_of("\"'", name) - name - 1);
  std::size_t from = text.find("id=\"" + std::string(id) + "\"");
  if (from == std::string_view::npos) return numbers;
  if (behind(text, "<float_array", from).empty() || behind(text, ">", from).empty()) return numbers;
  std::string_view words = text.substr(from, text.find('<', from) - from);
  for (std::string_view word = nextWord(words); !word.empty(); word = nextWord(words))
    if (const auto number = numberOf(word)) numbers.push_back(*number);
  return numbers;
}

}  // namespace

ShapeKeys ShapeKeys::ofFbx(std::string_view bytes) {
  ShapeKeys keys;
  keys.isFbx_ = true;
  const bool isBinary = bytes.starts_with("Kaydara FBX Binary");
  // A record of a binary file begins with the length of its name.
  const std::string_view mark = isBinary ? "\x0d"
                                           "DeformPercent"sv
                                         : "DeformPercent:"sv;
  for (std::size_t from = 0; from < bytes.size();) {
    const std::string_view rest = behind(bytes, mark, from);
    if (rest.empty()) break;
    if (const auto percent = recordNumber(rest, isBinary))
      keys.named_[keyNameBefore(bytes, from, isBinary)].push_back(*percent / 100.0);
  }
  return keys;
}

ShapeKeys ShapeKeys::ofCollada(std::string_view text) {
  ShapeKeys keys;
  for (std::size_t from = 0; from < text.size();) {
    if (behind(text, "MORPH_WEIGHT", from).empty()) break;
    keys.lists_.push_back(sourceNumbers(text, from));
  }
  return keys;
}

std::optional<double> ShapeKeys::namedWeight(const std::vector<Key>& keys, const std::string& name) const {
  const auto found = named_.find(name);
  if (found == named_.end()) {
    // Where all are alike, names do not matter.
    std::optional<double> all;
    for (const auto& [other, weights] : named_) {
      for (const double weight : weights) {
        if (all && *all != weight) return std::nullopt;
        all = weight;
      }
    }
    return all;
  }
  const std::vector<double>& weights = found->second;
  if (!std::all_of(weights.begin(), weights.end(), [&](double weight) { return weight == weights.front(); }))
    return std::nullopt;
  // Several shapes on the way of one key share its name; how they share its weight is not said.
  const auto ofName =
      std::count_if(keys.begin(), keys.end(), [&](const Key& key) { return key.name == name; });
  if (ofName > 1 && weights.front() != 0.0) return std::nullopt;
  return weights.front();
}

std::optional<std::vector<double>> ShapeKeys::weightsOf(const std::vector<Key>& keys) const {
  std::vector<double> made;
  if (isFbx_) {
    for (const Key& key : keys) {
      const auto weight = namedWeight(keys, key.name);
      if (!weight) return std::nullopt;
      made.push_back(*weight);
    }
    return made;
  }
  for (const std::vector<double>& list : lists_) {
    bool fits = list.size() == keys.size();
    for (std::size_t i = 0; i < keys.size() && fits; ++i)
      fits = std::abs((list[i] == 0.0 ? 1.0 : list[i]) - keys[i].weight) < 1e-5;
    if (!fits) continue;
    if (!made.empty() && made != list) return std::nullopt;
    made = list;
  }
  return made.size() == keys.size() ? std::optional(made) : std::nullopt;
}

}  // namespace modeling
