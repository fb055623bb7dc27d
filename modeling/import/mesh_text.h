#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "modeling/import/raw_mesh.h"

/// Text of mesh files: lines end as any system ends them, numbers have points whatever the language.
namespace modeling {

/// Walks a text line by line.
class MeshLines {
 public:
  explicit MeshLines(std::string_view text) : rest_(text) {}

  /// To the next line, without its end; false at the end of the text.
  bool next();
  std::string_view line() const { return line_; }
  /// "line 7", for a Problem.
  std::string place() const { return "line " + std::to_string(number_); }
  /// What stands behind this line.
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_, line_;
  std::uint64_t number_ = 0;
};

/// Cuts the first word off the text; empty at its end.
std::string_view nextWord(std::string_view& text);
/// The whole word as a number, which may be "nan" or infinite; nothing when it is none.
std::optional<double> numberOf(std::string_view word);
std::optional<std::int64_t> integerOf(std::string_view word);
/// The next three words as a point. A Problem says which is no number.
sim::Result<sim::Vec3> pointOf(std::string_view& text, const std::string& place);

std::string inLowerCase(std::string_view text);

/// Takes over what a comment or the head of a file says of its unit and of the axis that is up, if it does:
/// "cm, z up" of our own exports, "units: mm", "uses centimeters as units". What was stated before stays.
void takeStatement(std::string_view comment, RawMesh& raw);

/// What these bytes are when they are not what their name says: packed, of another format, or of letters of
/// two bytes. `what` is a Problem's; nothing where nothing is known of them.
std::optional<sim::Problem> whatElse(std::string_view bytes, std::string_view ending);

}  // namespace modeling
