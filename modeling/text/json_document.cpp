#include "modeling/text/json_document.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "modeling/text/spelling.h"

namespace modeling {
namespace {

using sim::Problem;

/// Follows the parser through the text, token by token, to say where each began. The parser reports tokens
/// only after checking them, so what stands here is known to be well formed.
class TokenCursor {
 public:
  explicit TokenCursor(std::string_view text) : text_(text) {
    if (text_.substr(0, 3) == "\xEF\xBB\xBF") at_ = 3;  // a byte order mark takes no column
  }

  /// Where the next value or key begins; moves behind it. An object or array ends behind its bracket.
  TextPosition next() {
    skipWhile(" \t\r\n,:");
    const TextPosition start = position_;
    const char first = at_ < text_.size() ? text_[at_] : '\0';
    if (first == '"') {
      skipText();
    } else if (std::string_view("{}[]").find(first) != std::string_view::npos) {
      step();
    } else {
      skipWhile("+-.0123456789eEtrufalsn");
    }
    return start;
  }

  /// Where the byte at `offset` stands, which must not lie before what was already passed.
  TextPosition positionOf(std::size_t offset) {
    while (at_ < std::min(offset, text_.size())) step();
    return position_;
  }

 private:
  void step() {
    const auto code = static_cast<unsigned char>(text_[at_++]);
    if (code == '\n') {
      ++position_.line;
      position_.column = 1;
    } else if ((code & 0xC0U) != 0x80U) {  // the rest of a character takes no column
      ++position_.column;
    }
  }
  void skipWhile(std::string_view letters) {
    while (at_ < text_.size() && letters.find(text_[at_]) != std::string_view::npos) step();
  }
  void skipText() {
    step();
    while (at_ < text_.size() && text_[at_] != '"') {
      if (text_[at_] == '\\') step();
      step();
    }
    if (at_ < text_.size()) step();
  }

  std::string_view text_;
  std::size_t at_ = 0;
  TextPosition position_;
};

/// Grows the tree from the parser's events; any `false` stops the parser.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, JsonDocument& document)
      : cursor_(text), text_(text), document_(document) {}

  const std::optional<Problem>& problem() const { return problem_; }

  bool null() override { return add(JsonValue::Null{}); }
  bool boolean(bool value) override { return add(value); }
  bool number_integer(number_integer_t value) override { return add(std::int64_t{value}); }
  bool number_unsigned(number_unsigned_t value) override { return add(std::uint64_t{value}); }
  bool number_float(number_float_t value, const string_t&) override { return add(value); }
  bool string(string_t& value) override { return add(std::move(value)); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return open(JsonValue::Object{}); }
  bool start_array(std::size_t) override { return open(JsonValue::Array{}); }
  bool end_array() override { return close(); }
  bool end_object() override {
    return firstRepeatedKey(std::get<JsonValue::Object>(open_.back()->content)) && close();
  }

  bool key(string_t& name) override {
    keyPosition_ = cursor_.next();
    key_ = std::move(name);
    return true;
  }

  bool parse_error(std::size_t offset, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    const bool tooLarge = error.id == 406;  // a number no double can hold
    if (tooLarge) {
      const TextPosition start = cursor_.next();
      return fail(start, "the number " + inQuotes(token) + " is too large", "give a finite number");
    }
    return fail(cursor_.positionOf(offset == 0 ? 0 : offset - 1), syntaxOf(error.what()),
                "correct the JSON here");
  }

 private:
  bool fail(const TextPosition& position, std::string what, std::string remedy) {
    if (!problem_) problem_ = Problem{document_.place(position), std::move(what), std::move(remedy)};
    return false;
  }

  /// The reason in the parser's message, without its own account of the place.
  static std::string syntaxOf(const std::string& message) {
    std::size_t start = message.find(" - ");
    start = start == std::string::npos ? message.rfind(": ") : start + 1;
    std::string reason = start == std::string::npos ? message : message.substr(start + 2);
    reason = reason.substr(0, reason.find("; last read"));
    std::string line = "this is not valid JSON: ";
    for (const char letter : reason.substr(0, 200)) {
      const auto code = static_cast<unsigned char>(letter);
      line += code < 0x20 || code > 0x7E ? '?' : letter == ';' ? ',' : letter;
    }
    return line;
  }

  template <class Content>
  bool add(Content content) {
    return place(std::move(content)) != nullptr;
  }

  template <class Content>
  bool open(Content content) {
    if (open_.size() >= kDeepest) {
      return fail(cursor_.next(), "this is nested more than " + std::to_string(kDeepest) + " deep",
                  "no scene needs that; the file is damaged");
    }
    JsonValue* const container = place(std::move(content));
    if (container != nullptr) open_.push_back(container);
    return container != nullptr;
  }

  bool close() {
    cursor_.next();
    open_.pop_back();
    return true;
  }

  /// Containers are filled depth first, so only the last child of the last container grows while it is
  /// pointed to.
  template <class Content>
  JsonValue* place(Content content) {
    JsonValue value{std::move(content), cursor_.next()};
    if (++count_ > kMostValues) {
      fail(value.position, "the file holds more than " + std::to_string(kMostValues) + " values",
           "move large data into a network file");
      return nullptr;
    }
    if (open_.empty()) {
      document_.root = std::move(value);
      return &document_.root;
    }
    if (JsonValue::Array* const array = open_.back()->array()) return &array->emplace_back(std::move(value));
    JsonValue::Object& object = *open_.back()->object();
    return &object.emplace_back(JsonMember{std::move(key_), keyPosition_, std::move(value)}).value;
  }

  bool firstRepeatedKey(const JsonValue::Object& object) {
    std::vector<const JsonMember*> members;
    for (const JsonMember& member : object) members.push_back(&member);
    std::stable_sort(members.begin(), members.end(),
                     [](const JsonMember* a, const JsonMember* b) { return a->key < b->key; });
    const auto repeated =
        std::adjacent_find(members.begin(), members.end(),
                           [](const JsonMember* a, const JsonMember* b) { return a->key == b->key; });
    if (repeated == members.end()) return true;
    const JsonMember& second = **std::next(repeated);
    return fail(second.position, inQuotes(second.key) + " is given twice", "keep one of them");
  }

  TokenCursor cursor_;
  std::string_view text_;
  JsonDocument& document_;
  std::vector<JsonValue*> open_;
  std::string key_;
  TextPosition keyPosition_;
  std::size_t count_ = 0;
  std::optional<Problem> problem_;
};

}  // namespace

bool JsonValue::isNumber() const {
  return std::holds_alternative<std::int64_t>(content) || std::holds_alternative<std::uint64_t>(content) ||
         std::holds_alternative<double>(content);
}

double JsonValue::number() const {
  assert(isNumber());
  if (const auto* integer = std::get_if<std::int64_t>(&content)) return static_cast<double>(*integer);
  if (const auto* natural = std::get_if<std::uint64_t>(&content)) return static_cast<double>(*natural);
  return std::get<double>(content);
}

const JsonValue* JsonValue::find(std::string_view key) const {
  if (object() == nullptr) return nullptr;
  const auto found = std::find_if(object()->begin(), object()->end(),
                                  [key](const JsonMember& member) { return member.key == key; });
  return found == object()->end() ? nullptr : &found->value;
}

JsonValue* JsonValue::find(std::string_view key) {
  return const_cast<JsonValue*>(std::as_const(*this).find(key));  // NOLINT: both belong to a mutable value
}

std::string_view JsonValue::kindName() const {
  constexpr std::string_view kNames[] = {"null",     "true or false", "a number", "a number",
                                         "a number", "a text",        "a list",   "an object"};
  return kNames[content.index()];
}

std::string JsonDocument::place(const TextPosition& position) const {
  return sources.at(position.source) + ':' + std::to_string(position.line) + ':' +
         std::to_string(position.column);
}

sim::Result<JsonDocument> parseJson(std::string_view text, const std::string& source) {
  JsonDocument document;
  document.sources = {source};
  TreeBuilder builder(text, document);
  const bool whole = nlohmann::json::sax_parse(text.begin(), text.end(), &builder);
  if (builder.problem()) return *builder.problem();
  if (!whole) return Problem{source + ":1:1", "this is not valid JSON", "correct the JSON"};
  return document;
}

}  // namespace modeling
