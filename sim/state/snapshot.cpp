#include "sim/state/snapshot.h"

#include <algorithm>
#include <bit>

#include <xxhash.h>

namespace sim {
namespace {

std::size_t countSet(const std::vector<std::uint8_t>& flags) {
  return flags.size() - static_cast<std::size_t>(std::ranges::count(flags, std::uint8_t{0}));
}

void makeOne(std::vector<std::uint8_t>& flags) {
  for (std::uint8_t& flag : flags) flag = flag != 0 ? 1 : 0;
}

/// Of the array and its length, on top of the arrays before it.
template <class T>
std::uint64_t hashed(const std::vector<T>& values, std::uint64_t before) {
  const std::uint64_t count = values.size();
  const std::uint64_t counted = XXH3_64bits_withSeed(&count, sizeof count, before);
  return XXH3_64bits_withSeed(values.data(), values.size() * sizeof(T), counted);
}

std::uint64_t hashed(const std::vector<Fragment>& fragments, std::uint64_t before) {
  // One word a member: between them a Fragment has bytes without a value.
  std::vector<std::uint64_t> words;
  words.reserve(5 * fragments.size());
  for (const Fragment& fragment : fragments) {
    for (const std::uint32_t number : {fragment.id, fragment.parent, fragment.nodeCount})
      words.push_back(number);
    for (const double number : {fragment.born, fragment.mass})
      words.push_back(std::bit_cast<std::uint64_t>(number));
  }
  return hashed(words, before);
}

}  // namespace

std::size_t Broken::lostBonds() const {
  return countSet(bonds);
}

std::size_t Broken::lostCells() const {
  return countSet(cells);
}

BrokenPointer sealed(Broken broken) {
  makeOne(broken.bonds);
  makeOne(broken.cells);
  broken.version = hashed(broken.bonds, 0);
  broken.version = hashed(broken.cells, broken.version);
  broken.version = hashed(broken.fragmentOfNode, broken.version);
  broken.version = hashed(broken.fragments, broken.version);
  return std::make_shared<const Broken>(std::move(broken));
}

const BrokenPointer& nothingBroken() {
  static const BrokenPointer kNothing = sealed({});
  return kNothing;
}

}  // namespace sim
