#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace modeling {

/// A word of a line and the column of its first letter, from 1.
struct Token {
  std::string_view text;
  std::uint32_t column = 1;

  /// The whole word as a number; nothing when it is none, is out of range, or (for double) is not finite.
  std::optional<std::int64_t> integer() const;
  std::optional<double> number() const;
};

/// Walks a text line by line and splits each into words, dropping what follows a '#' except for asking for
/// it.
class LineTokens {
 public:
  /// Words of a line beyond `mostWords` are not kept: a damaged line may have millions.
  explicit LineTokens(std::string_view text, std::size_t mostWords = 16)
      : rest_(text), mostWords_(mostWords) {}

  /// To the next line; false at the end of the text.
  bool next();
  std::uint32_t line() const { return line_; }
  const std::vector<Token>& words() const { return words_; }
  /// First word behind the '#', or "".
  std::string_view comment() const { return comment_; }

 private:
  std::string_view rest_;
  std::size_t mostWords_;
  std::uint32_t line_ = 0;
  std::vector<Token> words_;
  std::string_view comment_;
};

}  // namespace modeling
