#include "modeling/import/lammps_checks.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace modeling {

void LammpsIds::sort() {
  std::sort(ids_.begin(), ids_.end());
}

std::optional<std::uint32_t> LammpsIds::nodeOf(std::int64_t id) const {
  const auto found = std::lower_bound(ids_.begin(), ids_.end(), Entry{id, 0});
  if (found == ids_.end() || found->id != id) return std::nullopt;
  return found->node;
}

std::optional<LammpsIds::Entry> LammpsIds::givenTwice() const {
  const auto twice = std::adjacent_find(ids_.begin(), ids_.end(),
                                        [](const Entry& a, const Entry& b) { return a.id == b.id; });
  if (twice == ids_.end()) return std::nullopt;
  return *std::next(twice);
}

std::optional<std::pair<std::uint32_t, std::uint32_t>> twoInOnePlace(
    const std::vector<sim::Vec3>& positions) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto place = [&](std::uint32_t node) {
    const sim::Vec3& at = positions[node];
    return std::tuple(at.x(), at.y(), at.z(), node);
  };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
  const auto twice = std::adjacent_find(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return positions[a] == positions[b];
  });
  if (twice == order.end()) return std::nullopt;
  return std::pair(*twice, *std::next(twice));
}

std::optional<LammpsBond> secondOfPair(const std::vector<LammpsBond>& bonds) {
  const auto pairOf = [](const LammpsBond& bond) {
    return std::uint64_t{std::min(bond.a, bond.b)} << 32U | std::max(bond.a, bond.b);
  };
  std::vector<std::uint64_t> pairs;
  pairs.reserve(bonds.size());
  for (const LammpsBond& bond : bonds) pairs.push_back(pairOf(bond));
  std::sort(pairs.begin(), pairs.end());
  const auto twice = std::adjacent_find(pairs.begin(), pairs.end());
  if (twice == pairs.end()) return std::nullopt;
  return *std::find_if(bonds.rbegin(), bonds.rend(),
                       [&](const LammpsBond& bond) { return pairOf(bond) == *twice; });
}

}  // namespace modeling
