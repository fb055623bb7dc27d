#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

namespace tests {

/// Random numbers that are the same for a seed wherever they are drawn: unlike the distributions of the
/// standard library, which differ between libraries.
class Chance {
 public:
  explicit Chance(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t any() { return engine_(); }
  /// In [0, limit); 0 where the limit is 0.
  std::size_t below(std::size_t limit) {
    return limit == 0 ? 0 : static_cast<std::size_t>(engine_() % limit);
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace tests
