#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/base/result.h"

namespace modeling {

/// Where a value stands: in the document's `source`, both counted from 1, columns in characters.
struct TextPosition {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
  std::uint32_t source = 0;
};

struct JsonMember;

/// A JSON value that knows where it was read, so that every complaint can say so. For reading only.
struct JsonValue {
  using Array = std::vector<JsonValue>;
  using Object = std::vector<JsonMember>;  ///< in the order of the text, no key twice
  struct Null {};

  std::variant<Null, bool, std::int64_t, std::uint64_t, double, std::string, Array, Object> content;
  TextPosition position;

  const Array* array() const { return std::get_if<Array>(&content); }
  const Object* object() const { return std::get_if<Object>(&content); }
  Object* object() { return std::get_if<Object>(&content); }
  Array* array() { return std::get_if<Array>(&content); }
  const std::string* text() const { return std::get_if<std::string>(&content); }
  bool isNumber() const;
  /// Any of the three numbers; the value must be one.
  double number() const;
  /// The member's value, or nullptr (not an object, no such key).
  const JsonValue* find(std::string_view key) const;
  JsonValue* find(std::string_view key);
  /// "a number", "a text", "an object"...: for messages.
  std::string_view kindName() const;
};

struct JsonMember {
  std::string key;
  TextPosition position;  ///< of the key
  JsonValue value;
};

/// A text and the settings laid over it.
struct JsonDocument {
  std::vector<std::string> sources;  ///< what positions refer to: a file name first, then one a setting
  JsonValue root;

  /// "FILE:LINE:COLUMN"
  std::string place(const TextPosition& position) const;
};

/// Bounds beyond which a text is taken for damaged or hostile. They keep the memory of a document under 300
/// MB.
inline constexpr std::uintmax_t kLargestText = 64U << 20U;  ///< bytes
inline constexpr std::size_t kMostValues = 1'000'000;
inline constexpr std::size_t kDeepest = 64;

/// Reads JSON strictly: no comments, no key twice, valid UTF-8, within the bounds above. `source` names the
/// text in problems.
sim::Result<JsonDocument> parseJson(std::string_view text, const std::string& source);

}  // namespace modeling
