#include "tests/fuzz/text_cuts.h"

#include <algorithm>
#include <random>
#include <vector>

namespace tests {
namespace {

class Damager {
 public:
  Damager(std::string text, std::uint64_t seed) : text_(std::move(text)), random_(seed) {}

  std::string run() {
    switch (below(7)) {
      case 0:
        return text_.substr(0, below(text_.size()));
      case 1:
        flipBits(1 + below(8));
        break;
      case 2:
        replaceNumber({"99999999999999999999", "4000000000", "1e18", "-1", "1e400"});
        break;
      case 3:
        replaceNumber({"\"text\"", "{}", "[]", "null", "true", "{\"a\": [1, 2]}"});
        break;
      case 4:
        replaceNumber({"NaN", "nan", "-inf", "Infinity", "0x1p4", "1e-400000"});
        break;
      case 5:
        replaceNumber({std::string(100'000, '['), std::string(100'000, '{')});
        break;
      default:
        overwrite();
    }
    return text_;
  }

 private:
  std::size_t below(std::size_t limit) { return limit == 0 ? 0 : random_() % limit; }

  void flipBits(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      char& letter = text_[below(text_.size())];
      letter = static_cast<char>(static_cast<unsigned char>(letter) ^ (1U << below(8)));
    }
  }

  /// A run of digits somewhere, with sign, point and exponent.
  void replaceNumber(const std::vector<std::string>& substitutes) {
    const std::string digits = "0123456789";
    std::size_t start = text_.find_first_of(digits, below(text_.size()));
    if (start == std::string::npos) start = text_.find_first_of(digits);
    if (start == std::string::npos) return;
    const std::size_t end = std::min(text_.find_first_not_of(digits + ".eE+-", start), text_.size());
    text_.replace(start, end - start, substitutes[below(substitutes.size())]);
  }

  void overwrite() {
    const std::size_t start = below(text_.size());
    const std::size_t length = std::min(1 + below(64), text_.size() - start);
    if (below(2) == 0) {
      text_.insert(start, text_.substr(start, length));
      return;
    }
    for (std::size_t i = 0; i < length; ++i) text_[start + i] = static_cast<char>(below(256));
  }

  std::string text_;
  std::mt19937_64 random_;
};

}  // namespace

std::string damaged(const std::string& text, std::uint64_t seed) {
  return Damager(text, seed).run();
}

}  // namespace tests
