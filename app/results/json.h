#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace app {

struct JsonMember;

/// A value of JSON, as plain data: what commands and benchmarks leave in reports and tables, and read again.
/// Only json.cpp knows the library that writes and reads it, so that few sources have to compile that.
class Json {
 public:
  using Null = std::monostate;
  using Array = std::vector<Json>;
  using Object = std::vector<JsonMember>;  ///< in the order in which the members were added

  Json() = default;
  Json(bool value) : content_(value) {}
  Json(double value) : content_(value) {}
  Json(std::unsigned_integral auto value) : content_(std::uint64_t{value}) {}
  Json(std::signed_integral auto value) : content_(std::int64_t{value}) {}
  Json(const char* value) : content_(std::string(value)) {}
  Json(std::string_view value) : content_(std::string(value)) {}
  Json(std::string value) : content_(std::move(value)) {}
  Json(Array items) : content_(std::move(items)) {}
  Json(Object members) : content_(std::move(members)) {}
  /// An object, written {{"key", value}, ...}.
  Json(std::initializer_list<JsonMember> members);
  /// The value or, where there is none, null.
  template <class Value>
  Json(const std::optional<Value>& value) : Json(value ? Json(*value) : Json()) {}
  /// A list of each element.
  template <class Value>
  requires(!std::same_as<Value, Json> && !std::same_as<Value, JsonMember>)
      Json(const std::vector<Value>& values)
      : content_(Array(values.begin(), values.end())) {}

  /// The value as this type, or nullptr if it has another one. Numbers are double, std::uint64_t or
  /// std::int64_t: as they were made and, when read, whole ones of the latter two.
  template <class Value>
  const Value* get() const {
    return std::get_if<Value>(&content_);
  }

  /// The member of an object, made (null) where there is none; null becomes an object.
  Json& operator[](std::string_view key);
  /// The member of an object, or nullptr: no such member, or no object.
  const Json* find(std::string_view key) const;
  /// The member as a number of any kind, as a text or as a flag; nothing where there is no such member.
  std::optional<double> numberAt(std::string_view key) const;
  std::string textAt(std::string_view key) const;  ///< "": there is none
  bool flagAt(std::string_view key) const;         ///< false: there is none

 private:
  std::variant<Null, bool, std::int64_t, std::uint64_t, double, std::string, Array, Object> content_;
};

struct JsonMember {
  std::string key;
  Json value;
};

/// The text, each level indented by so many spaces; -1: all in one line.
std::string dumped(const Json& value, int indent = -1);
/// The text as a person likes to read it: short lists and objects stand in one line.
std::string readable(const Json& value);
/// What the text says; nothing where it is no JSON.
std::optional<Json> parseJson(std::string_view text);

}  // namespace app
