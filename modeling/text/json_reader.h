#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "modeling/text/json_document.h"
#include "modeling/text/json_fields.h"

namespace modeling {

/// Carries the first problem and all notes out of a reading, and words the problems that every kind of value
/// can have. All functions return false after they noted a problem.
class JsonReader {
 public:
  explicit JsonReader(const JsonDocument& document) : document_(document) {}

  const std::optional<sim::Problem>& problem() const { return problem_; }
  /// What the person should know though the file is read: in the order of the text.
  const std::vector<sim::Problem>& notes() const { return notes_; }

  bool fail(const TextPosition& position, std::string what, std::string remedy);
  bool failKind(const JsonValue& value, const Rule& rule, std::string_view expected);
  bool failNumber(const JsonValue& value, const Rule& rule, std::string_view expected);
  bool failChoice(const JsonValue& value, const Rule& rule, const std::vector<std::string>& choices);
  bool failMissing(const JsonValue& object, std::string_view key);

  /// A number within the rule's range.
  bool readNumber(const JsonValue& value, double& out, const Rule& rule);
  /// Degrees, or {"radians": number} for the few angles that no number of degrees gives exactly; `out` in
  /// radians.
  bool readAngle(const JsonValue& value, double& out, const Rule& rule);
  bool checkList(const JsonValue& value, const Rule& rule, std::size_t least, std::size_t most);
  /// An object with none but these keys. A retired key leaves a note.
  bool checkObject(const JsonValue& value, const Rule& rule, const std::vector<std::string>& keys,
                   std::span<const RetiredKey> retired = {});

 private:
  void noteRetired(const JsonMember& member, const RetiredKey& retired);

  const JsonDocument& document_;
  std::optional<sim::Problem> problem_;
  std::vector<sim::Problem> notes_;
};

/// "a number from 0 to 1".
std::string rangeText(const NumberRange& range);
/// What a schema and a table say of a field: its help and its unit, "Target edge of a cell. Unit: cm."
std::string describe(const Rule& rule, const Display& display);
/// What readAngle() reads back as exactly `radians`.
nlohmann::ordered_json writeAngle(double radians);
nlohmann::ordered_json angleSchema(const Rule& rule);
nlohmann::ordered_json numberSchema(std::string_view type, const Rule& rule);
/// An object to be given properties, which will be the only ones allowed.
nlohmann::ordered_json objectSchema();

}  // namespace modeling
