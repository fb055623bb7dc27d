#include "modeling/text/line_tokens.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace modeling {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";

template <class Number>
std::optional<Number> parsed(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  Number number{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), number);
  if (result.ec != std::errc{} || result.ptr != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

std::optional<std::int64_t> Token::integer() const {
  return parsed<std::int64_t>(text);
}

std::optional<double> Token::number() const {
  const std::optional<double> number = parsed<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

bool LineTokens::next() {
  words_.clear();
  comment_ = {};
  if (rest_.empty()) return false;
  ++line_;
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  const std::string_view whole = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));

  const std::size_t hash = std::min(whole.find('#'), whole.size());
  if (hash < whole.size()) {
    const std::size_t start = whole.find_first_not_of(kBlanks, hash + 1);
    if (start != std::string_view::npos) {
      comment_ = whole.substr(start, whole.find_first_of(kBlanks, start) - start);
    }
  }
  const std::string_view content = whole.substr(0, hash);
  std::size_t at = content.find_first_not_of(kBlanks);
  while (at != std::string_view::npos && words_.size() < mostWords_) {
    const std::size_t stop = std::min(content.find_first_of(kBlanks, at), content.size());
    words_.push_back({content.substr(at, stop - at), static_cast<std::uint32_t>(at + 1)});
    at = content.find_first_not_of(kBlanks, stop);
  }
  return true;
}

}  // namespace modeling
