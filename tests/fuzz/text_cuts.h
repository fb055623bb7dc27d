#pragma once

#include <cstdint>
#include <string>

namespace tests {

/// One random damage to a text file of values, drawn from the seed: cut off, bits flipped, a number made
/// huge, negative, not a number, or something of another kind, nesting a hundred thousand deep, a stretch
/// repeated or overwritten with noise.
std::string damaged(const std::string& text, std::uint64_t seed);

}  // namespace tests
