#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace sim {

/// Something a person or a file got wrong: where, what, and how to mend it. Never thrown; a value that
/// travels to where the person looks. What the programmer got wrong asserts instead.
struct Problem {
  std::string
      place;         ///< "FILE:LINE:COLUMN", a scene path such as "parts[2].reach", or "" where there is none
  std::string what;  ///< one sentence without a full stop
  std::string remedy;  ///< one sentence without a full stop, or ""

  /// "place: what; remedy" on one line, as the headless program prints it.
  std::string line() const {
    std::string text = place.empty() ? what : place + ": " + what;
    return remedy.empty() ? text : text + "; " + remedy;
  }
};

/// Either a value or the Problem that prevented it.
template <class Value>
class [[nodiscard]] Result {
 public:
  Result(Value value) : content_(std::move(value)) {}        // NOLINT(google-explicit-constructor)
  Result(Problem problem) : content_(std::move(problem)) {}  // NOLINT(google-explicit-constructor)

  bool ok() const { return std::holds_alternative<Value>(content_); }
  explicit operator bool() const { return ok(); }

  Value& value() & {
    assert(ok());
    return std::get<Value>(content_);
  }
  const Value& value() const& {
    assert(ok());
    return std::get<Value>(content_);
  }
  Value&& value() && {
    assert(ok());
    return std::get<Value>(std::move(content_));
  }
  Value* operator->() { return &value(); }
  const Value* operator->() const { return &value(); }
  Value& operator*() & { return value(); }
  const Value& operator*() const& { return value(); }
  Value&& operator*() && { return std::move(*this).value(); }

  const Problem& problem() const {
    assert(!ok());
    return std::get<Problem>(content_);
  }

 private:
  std::variant<Value, Problem> content_;
};

/// For operations that yield nothing but may fail.
struct Done {};
using Status = Result<Done>;

}  // namespace sim
