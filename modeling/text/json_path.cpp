#include "modeling/text/json_path.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "modeling/text/spelling.h"

namespace modeling {
namespace {

std::optional<std::size_t> asIndex(const std::string& step) {
  std::size_t index = 0;
  const char* end = step.data() + step.size();
  const auto parsed = std::from_chars(step.data(), end, index);
  if (parsed.ec != std::errc{} || parsed.ptr != end) return std::nullopt;
  return index;
}

std::string nameOf(const JsonValue& item) {
  const JsonValue* name = item.find("name");
  return name != nullptr && name->text() != nullptr ? *name->text() : "";
}

const JsonValue* entry(const JsonValue::Array& array, const std::string& step) {
  if (const auto index = asIndex(step)) return *index < array.size() ? &array[*index] : nullptr;
  const auto named =
      std::find_if(array.begin(), array.end(), [&](const JsonValue& item) { return nameOf(item) == step; });
  return named == array.end() ? nullptr : &*named;
}

const JsonValue* child(const JsonValue& value, const std::string& step) {
  if (const JsonValue::Array* array = value.array()) return entry(*array, step);
  if (const JsonValue* member = value.find(step)) return member;
  const auto index = asIndex(step);
  const JsonValue::Object* object = value.object();
  return object != nullptr && index && *index < object->size() ? &(*object)[*index].value : nullptr;
}

/// Tables whose keys are names given by the artist: nothing is added to them by a path.
bool isTableOfNames(const std::string& key) {
  return key == "materials" || key == "bondTypes";
}

std::vector<std::string> entriesOf(const JsonValue& value) {
  std::vector<std::string> names;
  if (const JsonValue::Object* object = value.object()) {
    for (const JsonMember& member : *object) names.push_back(member.key);
  }
  if (const JsonValue::Array* array = value.array()) {
    for (const JsonValue& item : *array) {
      names.push_back(nameOf(item).empty() ? std::to_string(names.size()) : nameOf(item));
    }
  }
  return names;
}

void moveTo(JsonValue& value, std::uint32_t source) {
  value.position.source = source;
  if (JsonValue::Array* array = value.array()) {
    for (JsonValue& item : *array) moveTo(item, source);
  }
  if (JsonValue::Object* object = value.object()) {
    for (JsonMember& member : *object) {
      member.position.source = source;
      moveTo(member.value, source);
    }
  }
}

sim::Result<JsonValue> parseSettingValue(const std::string& text, const std::string& source) {
  const bool isText =
      text.empty() || std::string_view("[{\"-0123456789").find(text[0]) == std::string_view::npos;
  sim::Result<JsonDocument> parsed = parseJson(text, source);
  if (parsed) return std::move(parsed->root);
  if (isText) return JsonValue{text, {}};
  return parsed.problem();
}

}  // namespace

std::vector<std::string> splitPath(std::string_view path) {
  std::vector<std::string> steps;
  std::size_t at = 0;
  while (at < path.size()) {
    std::size_t end = 0;
    std::size_t next = 0;
    if (path[at] == '[') {
      end = path.find(']', ++at);
      if (end == std::string_view::npos) return {};
      next = end + 1;
    } else {
      if (!steps.empty() && path[at++] != '.') return {};
      end = next = std::min(path.find_first_of(".[", at), path.size());
    }
    if (end == at) return {};
    steps.emplace_back(path.substr(at, end - at));
    at = next;
  }
  return steps;
}

const JsonValue& deepestValue(const JsonValue& root, std::string_view path) {
  const JsonValue* value = &root;
  for (const std::string& step : splitPath(path)) {
    const JsonValue* next = child(*value, step);
    if (next == nullptr) break;
    value = next;
  }
  return *value;
}

sim::Status applySetting(JsonDocument& document, const std::string& setting) {
  const std::size_t equals = setting.find('=');
  const std::string path = setting.substr(0, equals);
  const std::string source = "--set " + path;
  const std::vector<std::string> steps = splitPath(path);
  if (equals == std::string::npos || steps.empty()) {
    return sim::Problem{"--set " + setting, "this is not PATH=VALUE",
                        "write it like environment.gravity=[0,0,-4905]"};
  }
  sim::Result<JsonValue> value = parseSettingValue(setting.substr(equals + 1), source);
  if (!value) return value.problem();
  const auto sourceIndex = static_cast<std::uint32_t>(document.sources.size());
  document.sources.push_back(source);
  moveTo(*value, sourceIndex);

  const TextPosition here{1, 1, sourceIndex};
  JsonValue* target = &document.root;
  std::string table;
  for (const std::string& step : steps) {
    auto* next = const_cast<JsonValue*>(child(*target, step));  // NOLINT: the document is mutable
    const bool addable = target->object() != nullptr && !isTableOfNames(table);
    if (next == nullptr && !addable) {
      return sim::Problem{
          source, "there is no " + inQuotes(step) + " in " + (table.empty() ? "the scene" : inQuotes(table)),
          didYouMean(step, entriesOf(*target))};
    }
    if (next == nullptr) {
      next =
          &target->object()->emplace_back(JsonMember{step, here, JsonValue{JsonValue::Object{}, here}}).value;
    }
    target = next;
    table = step;
  }
  *target = std::move(value).value();
  return sim::Done{};
}

}  // namespace modeling
