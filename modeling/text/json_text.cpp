#include "modeling/text/json_text.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

namespace modeling {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kLineWidth = 100;
constexpr int kIndent = 2;

std::string key(const std::string& name) {
  return Json(name).dump() + ": ";
}

std::string oneLine(const Json& value) {
  if (value.is_number_float()) {
    const double number = value.get<double>();
    return std::isfinite(number) ? shortestNumber(number) : "null";  // JSON has no other word for it
  }
  if (!value.is_structured()) return value.dump();
  std::string text(1, value.is_object() ? '{' : '[');
  bool first = true;
  for (const auto& [name, item] : value.items()) {
    if (!first) text += ", ";
    first = false;
    if (value.is_object()) text += key(name);
    text += oneLine(item);
  }
  return text + (value.is_object() ? '}' : ']');
}

/// The text of `value` when it fits a line that has `used` characters on it already; else "". Gives up early,
/// so that a large tree is not written once for each of its levels.
std::string ifFits(const Json& value, std::size_t used);

std::size_t leavesUpTo(const Json& value, std::size_t most) {
  if (!value.is_structured()) return 1;
  std::size_t count = 1;
  for (const Json& item : value) {
    if (count > most) break;
    count += leavesUpTo(item, most - count);
  }
  return count;
}

std::string ifFits(const Json& value, std::size_t used) {
  if (leavesUpTo(value, kLineWidth) > kLineWidth) return "";
  std::string line = oneLine(value);
  return used + line.size() <= kLineWidth ? line : "";
}

void append(const Json& value, std::size_t indent, std::size_t used, std::string& text) {
  const std::string line = ifFits(value, used);
  if (!line.empty() || !value.is_structured() || value.empty()) {
    text += line.empty() ? oneLine(value) : line;
    return;
  }
  text += value.is_object() ? '{' : '[';
  bool first = true;
  for (const auto& [name, item] : value.items()) {
    text += first ? "\n" : ",\n";
    first = false;
    const std::size_t inner = indent + kIndent;
    text.append(inner, ' ');
    const std::string label = value.is_object() ? key(name) : "";
    text += label;
    append(item, inner, inner + label.size(), text);
  }
  text += '\n';
  text.append(indent, ' ');
  text += value.is_object() ? '}' : ']';
}

}  // namespace

std::string shortestNumber(double number) {
  assert(std::isfinite(number));
  std::array<char, 32> digits{};
  const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  std::string text(digits.data(), written.ptr);
  return text == "-0" ? "-0.0" : text;  // "-0" would be read as a whole number, which has no sign of zero
}

std::string jsonText(const nlohmann::ordered_json& value) {
  std::string text;
  append(value, 0, 0, text);
  return text + '\n';
}

}  // namespace modeling
