#include "modeling/text/json_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "modeling/text/json_text.h"
#include "modeling/text/spelling.h"

namespace modeling {
namespace {

using Json = nlohmann::ordered_json;

std::string listed(const std::vector<std::string>& choices) {
  std::string text;
  for (const std::string& choice : choices) text += (text.empty() ? "" : ", ") + choice;
  return text;
}

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

Rule inRadians(Rule degrees) {
  degrees.range.least *= kRadiansPerDegree;
  degrees.range.most *= kRadiansPerDegree;
  return degrees;
}

std::string_view nameOf(const Rule& rule) {
  return rule.key.empty() ? "the file" : rule.key;
}

}  // namespace

bool JsonReader::fail(const TextPosition& position, std::string what, std::string remedy) {
  if (!problem_) problem_ = sim::Problem{document_.place(position), std::move(what), std::move(remedy)};
  return false;
}

bool JsonReader::failKind(const JsonValue& value, const Rule& rule, std::string_view expected) {
  return fail(value.position, std::string(nameOf(rule)) + " holds " + std::string(value.kindName()),
              "give " + std::string(expected));
}

bool JsonReader::failNumber(const JsonValue& value, const Rule& rule, std::string_view expected) {
  return fail(value.position, std::string(nameOf(rule)) + " holds " + shortestNumber(value.number()),
              "give " + std::string(expected));
}

bool JsonReader::failChoice(const JsonValue& value, const Rule& rule,
                            const std::vector<std::string>& choices) {
  return fail(value.position, std::string(nameOf(rule)) + " does not know " + inQuotes(*value.text()),
              didYouMean(*value.text(), choices) + "? There are " + listed(choices));
}

bool JsonReader::failMissing(const JsonValue& object, std::string_view key) {
  return fail(object.position, "the key " + inQuotes(key) + " is missing", "add it to this object");
}

bool JsonReader::readNumber(const JsonValue& value, double& out, const Rule& rule) {
  if (!value.isNumber()) return failKind(value, rule, rangeText(rule.range));
  const double number = value.number();
  if (!rule.range.holds(number)) return failNumber(value, rule, rangeText(rule.range));
  out = number;
  return true;
}

bool JsonReader::readAngle(const JsonValue& value, double& out, const Rule& rule) {
  if (value.object() != nullptr) {
    const JsonValue* radians = value.find("radians");
    if (radians == nullptr || value.object()->size() != 1)
      return failKind(value, rule, "an angle in degrees");
    return readNumber(*radians, out, inRadians(rule));
  }
  if (!readNumber(value, out, rule)) return false;
  out *= kRadiansPerDegree;
  return true;
}

bool JsonReader::checkList(const JsonValue& value, const Rule& rule, std::size_t least, std::size_t most) {
  const std::string wanted = least == most ? "a list of " + std::to_string(least) : std::string("a list");
  if (value.array() == nullptr) return failKind(value, rule, wanted);
  const std::size_t count = value.array()->size();
  if (count >= least && count <= most) return true;
  return fail(value.position, std::string(nameOf(rule)) + " has " + std::to_string(count) + " entries",
              "give " + wanted);
}

bool JsonReader::checkObject(const JsonValue& value, const Rule& rule, const std::vector<std::string>& keys,
                             std::span<const RetiredKey> retired) {
  if (value.object() == nullptr) return failKind(value, rule, "an object");
  for (const JsonMember& member : *value.object()) {
    if (std::find(keys.begin(), keys.end(), member.key) != keys.end()) continue;
    const auto old = std::ranges::find(retired, member.key, &RetiredKey::key);
    if (old != retired.end()) {
      noteRetired(member, *old);
      continue;
    }
    return fail(member.position, "there is no key " + inQuotes(member.key) + " here",
                didYouMean(member.key, keys));
  }
  return true;
}

void JsonReader::noteRetired(const JsonMember& member, const RetiredKey& retired) {
  notes_.push_back({document_.place(member.position),
                    inQuotes(member.key) + " means nothing since " + std::string(retired.since) + ", as " +
                        std::string(retired.why),
                    "take it out"});
}

std::string rangeText(const NumberRange& range) {
  return "a number from " + shortestNumber(range.least) + " to " + shortestNumber(range.most);
}

std::string describe(const Rule& rule, const Display& display) {
  const std::string_view unit = unitInFile(display.dimension);
  return std::string(rule.help) + (unit.empty() ? "" : " Unit: " + std::string(unit) + ".");
}

Json writeAngle(double radians) {
  const double degrees = radians / kRadiansPerDegree;
  double rounded = std::round(degrees * 1e9) / 1e9;  // what a person wrote is most often a round number
  if (rounded * kRadiansPerDegree == radians) return rounded;
  for (const double towards :
       {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}) {
    rounded = degrees;
    for (int i = 0; i < 3; ++i) {
      if (rounded * kRadiansPerDegree == radians) return rounded;
      rounded = std::nextafter(rounded, towards);
    }
  }
  return {{"radians", radians}};
}

Json angleSchema(const Rule& rule) {
  const Json exact = {{"type", "object"},
                      {"properties", {{"radians", numberSchema("number", inRadians(rule))}}},
                      {"required", {"radians"}},
                      {"additionalProperties", false}};
  return {{"anyOf", {numberSchema("number", rule), exact}}};
}

Json numberSchema(std::string_view type, const Rule& rule) {
  return {{"type", type}, {"minimum", rule.range.least}, {"maximum", rule.range.most}};
}

Json objectSchema() {
  return {{"type", "object"},
          {"properties", Json::object()},
          {"required", Json::array()},
          {"additionalProperties", false}};
}

}  // namespace modeling
