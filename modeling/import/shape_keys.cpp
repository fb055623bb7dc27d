#include "modeling/import/shape_keys.h"

#include <algorithm>
#include <cstring>
#include <iterator>

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

}  // namespace

ShapeKeys::ShapeKeys(std::string_view bytes) {
  const bool isBinary = bytes.starts_with("Kaydara FBX Binary");
  // A record of a binary file begins with the length of its name.
  const std::string_view mark = isBinary ? "\x0d"
                                           "DeformPercent"sv
                                         : "DeformPercent:"sv;
  for (std::size_t from = 0; from < bytes.size();) {
    const std::string_view rest = behind(bytes, mark, from);
    if (rest.empty()) break;
    if (const auto percent = recordNumber(rest, isBinary))
      weights_[keyNameBefore(bytes, from, isBinary)].push_back(*percent / 100.0);
  }
}

std::optional<double> ShapeKeys::weightOf(const std::string& name,
                                          const std::vector<std::string>& names) const {
  const auto found = weights_.find(name);
  std::vector<double> stated;
  for (const auto& [other, weights] : weights_)
    // Where all are alike, names do not matter.
    if (found == weights_.end() || other == name) stated.insert(stated.end(), weights.begin(), weights.end());
  if (stated.empty() || std::count(stated.begin(), stated.end(), stated.front()) != std::ssize(stated))
    return std::nullopt;
  // Several shapes on the way of one key share its name; how they share its weight is not said.
  if (std::count(names.begin(), names.end(), name) > 1 && stated.front() != 0.0) return std::nullopt;
  return stated.front();
}

std::optional<std::vector<double>> ShapeKeys::weightsOf(const std::vector<std::string>& names) const {
  std::vector<double> weights;
  for (const std::string& name : names) {
    const auto weight = weightOf(name, names);
    if (!weight) return std::nullopt;
    weights.push_back(*weight);
  }
  return weights;
}

}  // namespace modeling
