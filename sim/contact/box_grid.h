#pragma once

#include <array>
#include <vector>

#include <Eigen/Geometry>

#include "sim/base/types.h"

namespace sim {

/// Boxes of fragments, to find those of others near a place. Each stands in the cube of its middle; the cubes
/// of all space share a table, which space wraps around, so that it does not matter how far things fly apart.
class BoxGrid {
 public:
  /// `edge` of a cube, cm: about the size of the boxes.
  explicit BoxGrid(double edge) : edge_(edge) {}

  /// In order of the indices.
  void add(std::uint32_t index, FragmentId fragment, const Eigen::AlignedBox3d& box);
  /// Once all are in, and before any is found.
  void sort();
  /// Those from `from` on, of other fragments, that overlap this box, ascending; rounded outwards to floats,
  /// so that some only nearly do.
  void find(FragmentId fragment, const Eigen::AlignedBox3d& box, std::uint32_t from,
            std::vector<std::uint32_t>& found) const;

 private:
  struct Entry {
    std::array<float, 3> low{}, high{};
    std::uint32_t index = 0;
    FragmentId fragment = 0;
  };
  std::int64_t cubeAt(double coordinate) const;
  std::size_t slotOf(const Entry& entry) const;

  double edge_;
  std::int64_t side_ = 1;                ///< cubes a side of the table, a power of two
  std::array<double, 3> largestHalf_{};  ///< cm: no box is larger than twice this
  std::vector<Entry> entries_;           ///< by slot once they are sorted
  std::vector<std::uint32_t> first_;     ///< by slot, and one more
  std::vector<FragmentId> only_;         ///< by slot: the fragment of all in it; kNone: they are of several
};

}  // namespace sim
