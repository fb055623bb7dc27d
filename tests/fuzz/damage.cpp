#include "tests/fuzz/damage.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "tests/fuzz/chance.h"
#include "tests/fuzz/json_damage.h"
#include "tests/fuzz/take_damage.h"
#include "tests/fuzz/text_cuts.h"

namespace tests {
namespace {

constexpr std::size_t kLongestBlock = 4096;
/// Repeating grows inputs; beyond this they test patience only.
constexpr std::size_t kLargest = std::size_t{1} << 22U;

void flipBits(std::string& bytes, Chance& chance) {
  for (std::size_t n = 1 + chance.below(8); n > 0; --n) {
    char& byte = bytes[chance.below(bytes.size())];
    byte = static_cast<char>(static_cast<unsigned char>(byte) ^ (1U << chance.below(8)));
  }
}

struct Block {
  std::size_t first = 0;
  std::size_t length = 0;
};
Block someBlock(const std::string& bytes, Chance& chance) {
  const std::size_t first = chance.below(bytes.size());
  const std::size_t longest = chance.below(2) == 0 ? 64 : kLongestBlock;
  return {first, std::min(1 + chance.below(longest), bytes.size() - first)};
}

void repeat(std::string& bytes, Chance& chance) {
  const Block block = someBlock(bytes, chance);
  const std::string piece = bytes.substr(block.first, block.length);
  std::size_t times = std::array<std::size_t, 4>{1, 2, 30, 1000}[chance.below(4)];
  std::string all;
  for (; times > 0 && all.size() < kLargest; --times) all += piece;
  bytes.insert(chance.below(2) == 0 ? block.first : chance.below(bytes.size()), all);
}

void overwrite(std::string& bytes, Chance& chance) {
  const Block block = someBlock(bytes, chance);
  const bool zeros = chance.below(3) == 0;
  for (std::size_t i = 0; i < block.length; ++i)
    bytes[block.first + i] = zeros ? '\0' : static_cast<char>(chance.below(256));
}

/// Little-endian, as all of our binary inputs have it, or the other way round.
void replaceBinaryNumber(std::string& bytes, Chance& chance) {
  constexpr std::array<std::uint64_t, 14> kNumbers{0,
                                                   1,
                                                   2,
                                                   0x7f,
                                                   0xff,
                                                   0x7fff,
                                                   0xffff,
                                                   0x7fffffff,
                                                   0x80000000,
                                                   0xffffffff,
                                                   20'000'000,
                                                   std::uint64_t{1} << 33U,
                                                   std::uint64_t{1} << 61U,
                                                   ~std::uint64_t{0}};
  const std::size_t size = std::size_t{1} << chance.below(4);
  if (bytes.size() < size) return;
  const std::size_t reach = chance.below(2) == 0 ? std::min<std::size_t>(bytes.size(), 256) : bytes.size();
  const std::size_t at = std::min(chance.below(reach), bytes.size() - size);
  std::uint64_t number = kNumbers[chance.below(kNumbers.size())];
  if (size >= 4 && chance.below(4) == 0) {
    const std::array<float, 5> floats{1e30F, -1e-30F, std::numeric_limits<float>::quiet_NaN(),
                                      std::numeric_limits<float>::infinity(), 0.0F};
    std::uint32_t bits = 0;
    std::memcpy(&bits, &floats[chance.below(floats.size())], sizeof bits);
    number = bits;
  }
  char digits[8];
  std::memcpy(digits, &number, sizeof digits);
  if (chance.below(4) == 0) std::reverse(digits, digits + size);
  std::memcpy(bytes.data() + at, digits, size);
}

void damageBytes(std::string& bytes, const std::string& other, Chance& chance) {
  switch (chance.below(6)) {
    case 0:
      return flipBits(bytes, chance);
    case 1:
      return bytes.resize(chance.below(bytes.size()));
    case 2: {
      const Block block = someBlock(bytes, chance);
      bytes.erase(block.first, block.length);
      return;
    }
    case 3:
      return repeat(bytes, chance);
    case 4:
      bytes = bytes.substr(0, chance.below(bytes.size())) + other.substr(chance.below(other.size() + 1));
      return;
    default:
      return overwrite(bytes, chance);
  }
}

}  // namespace

std::string damagedInput(const std::string& whole, const std::string& other, Nature nature,
                         std::uint64_t seed) {
  Chance chance(seed);
  std::string bytes = whole;
  // One or, now and then, some of them.
  for (std::size_t n = chance.below(4) == 0 ? 3 : 1; n > 0 && !bytes.empty(); --n) {
    // Few other damages leave JSON that can be read.
    const bool byNature = chance.below(nature == Nature::json ? 12 : 3) > 0;
    if (!byNature) {
      damageBytes(bytes, other, chance);
    } else if (nature == Nature::json && chance.below(8) > 0) {
      damageJson(bytes, chance);
    } else if (nature == Nature::take) {
      damageTake(bytes, chance);
    } else if (nature == Nature::binary) {
      replaceBinaryNumber(bytes, chance);
    } else {
      bytes = damaged(bytes, chance.any());
    }
  }
  return bytes;
}

}  // namespace tests
