#include "sim/contact/hash_grid.h"

#include <bit>
#include <cmath>

namespace sim {
namespace {

/// The upper half of a product with the golden ratio: the table's size is a power of two, and its index the
/// low bits of this.
std::size_t hashOf(std::uint64_t place) {
  return static_cast<std::size_t>((place * 0x9e3779b97f4a7c15ULL) >> 32);
}

}  // namespace

std::uint32_t HashGrid::find(Place at) const {
  const std::size_t mask = table_.size() - 1;
  for (std::size_t slot = hashOf(at) & mask;; slot = (slot + 1) & mask) {
    if (table_[slot] == kNone || cubes_[table_[slot]].at == at) return table_[slot];
  }
}

std::uint32_t HashGrid::findOrAdd(Place at, FragmentId tag) {
  const std::size_t mask = table_.size() - 1;
  std::size_t slot = hashOf(at) & mask;
  while (table_[slot] != kNone && cubes_[table_[slot]].at != at) slot = (slot + 1) & mask;
  if (table_[slot] == kNone) {
    table_[slot] = static_cast<std::uint32_t>(cubes_.size());
    cubes_.push_back({at, tag, 0, 0});
  } else if (cubes_[table_[slot]].tag != tag) {
    cubes_[table_[slot]].tag = kMixed;
  }
  return table_[slot];
}

void HashGrid::build(const NodeVectors& positions, std::span<const NodeIndex> nodes,
                     std::span<const FragmentId> fragmentOfNode, double edge) {
  const std::size_t count = nodes.size();
  table_.assign(std::bit_ceil(2 * count + 1), kNone);
  cubes_.clear();
  cubeOfNode_.resize(count);
  for (std::size_t n = 0; n < count; ++n) {
    const NodeIndex node = nodes[n];
    const auto along = [&](std::size_t k) {
      return static_cast<std::uint64_t>(
          static_cast<std::int64_t>(std::floor(positions.axis(k)[node] / edge)));
    };
    const std::uint32_t cube = findOrAdd(placeOf(along(0), along(1), along(2)), fragmentOfNode[node]);
    cubeOfNode_[n] = cube;
    ++cubes_[cube].last;
  }
  std::uint32_t first = 0;
  for (Cube& cube : cubes_) {
    const std::uint32_t size = cube.last;
    cube.first = cube.last = first;
    first += size;
  }
  nodes_.resize(count);
  for (std::size_t n = 0; n < count; ++n) nodes_[cubes_[cubeOfNode_[n]].last++] = nodes[n];
}

std::size_t HashGrid::memoryBytes() const {
  return (table_.capacity() + nodes_.capacity() + cubeOfNode_.capacity()) * sizeof(std::uint32_t) +
         cubes_.capacity() * sizeof(Cube);
}

}  // namespace sim
