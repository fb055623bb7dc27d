#include "app/results/json.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "modeling/text/json_text.h"

namespace app {
namespace {

using Library = nlohmann::ordered_json;

Library toLibrary(const Json& value);

Library toLibrary(const Json::Array& items) {
  Library list = Library::array();
  for (const Json& item : items) list.push_back(toLibrary(item));
  return list;
}

Library toLibrary(const Json::Object& members) {
  Library object = Library::object();
  for (const auto& [key, value] : members) object[key] = toLibrary(value);
  return object;
}

Library toLibrary(const Json& value) {
  if (const auto* const items = value.get<Json::Array>()) return toLibrary(*items);
  if (const auto* const members = value.get<Json::Object>()) return toLibrary(*members);
  if (const auto* const text = value.get<std::string>()) return *text;
  if (const auto* const flag = value.get<bool>()) return *flag;
  if (const auto* const number = value.get<double>()) return *number;
  if (const auto* const number = value.get<std::uint64_t>()) return *number;
  if (const auto* const number = value.get<std::int64_t>()) return *number;
  return nullptr;
}

Json fromLibrary(const Library& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number_unsigned()) return value.get<std::uint64_t>();
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number_float()) return value.get<double>();
  if (value.is_array()) {
    Json::Array items;
    for (const Library& item : value) items.push_back(fromLibrary(item));
    return items;
  }
  if (!value.is_object()) return {};
  Json::Object members;
  for (const auto& [key, member] : value.items()) members.push_back({key, fromLibrary(member)});
  return members;
}

}  // namespace

Json::Json(std::initializer_list<JsonMember> members) : content_(Object(members)) {}

Json& Json::operator[](std::string_view key) {
  if (get<Null>() != nullptr) content_ = Object();
  Object& members = std::get<Object>(content_);
  const auto found =
      std::find_if(members.begin(), members.end(), [&](const JsonMember& one) { return one.key == key; });
  if (found != members.end()) return found->value;
  return members.emplace_back(JsonMember{std::string(key), Json()}).value;
}

const Json* Json::find(std::string_view key) const {
  const auto* const members = get<Object>();
  if (members == nullptr) return nullptr;
  const auto found =
      std::find_if(members->begin(), members->end(), [&](const JsonMember& one) { return one.key == key; });
  return found == members->end() ? nullptr : &found->value;
}

std::optional<double> Json::numberAt(std::string_view key) const {
  const Json* const member = find(key);
  if (member == nullptr) return std::nullopt;
  if (const auto* const number = member->get<double>()) return *number;
  if (const auto* const number = member->get<std::uint64_t>()) return static_cast<double>(*number);
  if (const auto* const number = member->get<std::int64_t>()) return static_cast<double>(*number);
  return std::nullopt;
}

std::string Json::textAt(std::string_view key) const {
  const Json* const member = find(key);
  const auto* const text = member == nullptr ? nullptr : member->get<std::string>();
  return text == nullptr ? "" : *text;
}

bool Json::flagAt(std::string_view key) const {
  const Json* const member = find(key);
  const auto* const flag = member == nullptr ? nullptr : member->get<bool>();
  return flag != nullptr && *flag;
}

std::string dumped(const Json& value, int indent) {
  return toLibrary(value).dump(indent);
}

std::string readable(const Json& value) {
  return modeling::jsonText(toLibrary(value));
}

std::optional<Json> parseJson(std::string_view text) {
  const Library value = Library::parse(text, nullptr, false);
  if (value.is_discarded()) return std::nullopt;
  return fromLibrary(value);
}

}  // namespace app
