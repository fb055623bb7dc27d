#include "modeling/material/congruence.h"

#include <array>
#include <bit>
#include <cmath>
#include <unordered_map>

#include "modeling/material/bond_fit.h"

namespace modeling {
namespace {

struct Distances {
  std::array<double, kPairsPerCell> squared;
  double sum = 0.0;
};

Distances distances(const std::vector<Vec3>& nodes, const sim::CellCorners& cell) {
  Distances result;
  for (std::size_t p = 0; p < kPairsPerCell; ++p) {
    result.squared[p] = (nodes[cell[kCornerPairs[p].b]] - nodes[cell[kCornerPairs[p].a]]).squaredNorm();
    result.sum += result.squared[p];
  }
  return result;
}

bool congruent(const Distances& a, const Distances& b) {
  // In a cube the sum is 48 squared edges; a length that differs by the share of an edge differs by twice
  // that in its square.
  const double tolerance = 2.0 * kCongruence * a.sum / 48.0;
  for (std::size_t p = 0; p < kPairsPerCell; ++p)
    if (std::abs(a.squared[p] - b.squared[p]) > tolerance) return false;
  return true;
}

/// Classes by the leading bits of the sum of squared distances. Bins are 6e-8 wide, so that what is congruent
/// lies in one bin or in two neighbouring ones.
class Classes {
 public:
  /// The first class that is congruent and has this mark, or kNone.
  std::uint32_t find(const Distances& shape, std::uint8_t mark) const {
    const std::uint64_t low = bin(shape.sum * (1.0 - 4.0 * kCongruence));
    const std::uint64_t high = bin(shape.sum * (1.0 + 4.0 * kCongruence));
    std::uint32_t found = findIn(low, shape, mark);
    if (high != low) found = std::min(found, findIn(high, shape, mark));
    return found;
  }

  bool matches(std::uint32_t index, const Distances& shape, std::uint8_t mark) const {
    return entries_[index].mark == mark && congruent(entries_[index].shape, shape);
  }

  std::uint32_t add(const Distances& shape, std::uint8_t mark) {
    const auto index = static_cast<std::uint32_t>(entries_.size());
    entries_.push_back({shape, mark});
    bins_[bin(shape.sum)].push_back(index);
    return index;
  }

 private:
  struct Entry {
    Distances shape;
    std::uint8_t mark;
  };

  static std::uint64_t bin(double sum) { return std::bit_cast<std::uint64_t>(sum) >> 28U; }

  std::uint32_t findIn(std::uint64_t key, const Distances& shape, std::uint8_t mark) const {
    const auto found = bins_.find(key);
    if (found == bins_.end()) return sim::kNone;
    for (const std::uint32_t index : found->second)
      if (matches(index, shape, mark)) return index;
    return sim::kNone;
  }

  std::vector<Entry> entries_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> bins_;
};

}  // namespace

Congruence congruentCells(const std::vector<Vec3>& nodes, const std::vector<sim::CellCorners>& cells,
                          const std::vector<std::uint8_t>& marks) {
  Congruence result;
  result.classOfCell.reserve(cells.size());
  Classes classes;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const Distances shape = distances(nodes, cells[cell]);
    std::uint32_t index = classes.find(shape, marks[cell]);
    if (index == sim::kNone) {
      index = classes.add(shape, marks[cell]);
      result.representatives.push_back(static_cast<sim::CellIndex>(cell));
    }
    result.classOfCell.push_back(index);
  }
  return result;
}

}  // namespace modeling
