#include "modeling/material/congruence.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <unordered_map>

#include <Eigen/Geometry>

#include "modeling/material/bond_fit.h"

namespace modeling {
namespace {

struct Shape {
  std::array<double, kPairsPerCell> squared;  ///< distances
  double sum = 0.0;
  std::uint8_t mark = 0;
  bool mirrored = false;  ///< which distances don't tell
};

Shape shapeOf(const std::vector<Vec3>& nodes, const sim::CellCorners& cell, std::uint8_t mark) {
  Shape result;
  result.mark = mark;
  for (std::size_t p = 0; p < kPairsPerCell; ++p) {
    result.squared[p] = (nodes[cell[kCornerPairs[p].b]] - nodes[cell[kCornerPairs[p].a]]).squaredNorm();
    result.sum += result.squared[p];
  }
  const Vec3& origin = nodes[cell[0]];
  result.mirrored =
      (nodes[cell[1]] - origin).cross(nodes[cell[2]] - origin).dot(nodes[cell[4]] - origin) < 0.0;
  return result;
}

bool congruent(const Shape& a, const Shape& b) {
  if (a.mark != b.mark || a.mirrored != b.mirrored) return false;
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
  /// The first class that is congruent, or kNone.
  std::uint32_t find(const Shape& shape) const {
    const std::uint64_t low = bin(shape.sum * (1.0 - 4.0 * kCongruence));
    const std::uint64_t high = bin(shape.sum * (1.0 + 4.0 * kCongruence));
    std::uint32_t found = findIn(low, shape);
    if (high != low) found = std::min(found, findIn(high, shape));
    return found;
  }

  std::uint32_t add(const Shape& shape) {
    const auto index = static_cast<std::uint32_t>(shapes_.size());
    shapes_.push_back(shape);
    bins_[bin(shape.sum)].push_back(index);
    return index;
  }

 private:
  static std::uint64_t bin(double sum) { return std::bit_cast<std::uint64_t>(sum) >> 28U; }

  std::uint32_t findIn(std::uint64_t key, const Shape& shape) const {
    const auto found = bins_.find(key);
    if (found == bins_.end()) return sim::kNone;
    for (const std::uint32_t index : found->second)
      if (congruent(shapes_[index], shape)) return index;
    return sim::kNone;
  }

  std::vector<Shape> shapes_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> bins_;
};

}  // namespace

Congruence congruentCells(const std::vector<Vec3>& nodes, const std::vector<sim::CellCorners>& cells,
                          const std::vector<std::uint8_t>& marks) {
  Congruence result;
  result.classOfCell.reserve(cells.size());
  Classes classes;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const Shape shape = shapeOf(nodes, cells[cell], marks[cell]);
    std::uint32_t index = classes.find(shape);
    if (index == sim::kNone) {
      index = classes.add(shape);
      result.representatives.push_back(static_cast<sim::CellIndex>(cell));
    }
    result.classOfCell.push_back(index);
  }
  return result;
}

}  // namespace modeling
