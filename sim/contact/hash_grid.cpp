#include "sim/contact/hash_grid.h"

#include <bit>
#include <cmath>

#include "sim/base/random.h"

namespace sim {
namespace {

std::size_t hashOf(const std::array<std::int64_t, 3>& at) {
  std::uint64_t hash = 0;
  for (const std::int64_t coordinate : at) hash = mixBits(hash ^ static_cast<std::uint64_t>(coordinate));
  return static_cast<std::size_t>(hash);
}

}  // namespace

std::uint32_t HashGrid::find(const Place& at) const {
  const std::size_t mask = table_.size() - 1;
  for (std::size_t slot = hashOf(at) & mask;; slot = (slot + 1) & mask) {
    if (table_[slot] == kNone || cubes_[table_[slot]].at == at) return table_[slot];
  }
}

std::uint32_t HashGrid::findOrAdd(const Place& at, FragmentId tag) {
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

void HashGrid::build(const NodeVectors& positions, std::span<const FragmentId> fragmentOfNode, double edge) {
  const std::size_t count = positions.size();
  table_.assign(std::bit_ceil(2 * count + 1), kNone);
  cubes_.clear();
  cubeOfNode_.resize(count);
  for (std::size_t node = 0; node < count; ++node) {
    Place at;
    for (std::size_t k = 0; k < 3; ++k)
      at[k] = static_cast<std::int64_t>(std::floor(positions.axis(k)[node] / edge));
    const std::uint32_t cube = findOrAdd(at, fragmentOfNode[node]);
    cubeOfNode_[node] = cube;
    ++cubes_[cube].last;
  }
  std::uint32_t first = 0;
  for (Cube& cube : cubes_) {
    const std::uint32_t size = cube.last;
    cube.first = cube.last = first;
    first += size;
  }
  nodes_.resize(count);
  for (std::size_t node = 0; node < count; ++node)
    nodes_[cubes_[cubeOfNode_[node]].last++] = static_cast<NodeIndex>(node);
}

std::size_t HashGrid::memoryBytes() const {
  return (table_.capacity() + nodes_.capacity() + cubeOfNode_.capacity()) * sizeof(std::uint32_t) +
         cubes_.capacity() * sizeof(Cube);
}

}  // namespace sim
