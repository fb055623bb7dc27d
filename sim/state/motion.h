#pragma once

#include <array>

#include "sim/base/aligned.h"
#include "sim/base/blocks.h"
#include "sim/base/types.h"

namespace sim {

/// A vector a node, one array a coordinate, padded on both sides: the kernel reads whole blocks at a
/// neighbour's offset, so up to fifteen nodes before the first and behind the last. Padding is zero.
///
/// Large arrays all begin at the same place in a page, and lines of the same place share eight ways of the
/// first cache. A step goes through two dozen arrays at once, so each is shifted by some lines: a twentieth
/// of its time.
class NodeVectors {
 public:
  NodeVectors() = default;
  /// `place`: another for each of those that are gone through together.
  explicit NodeVectors(std::size_t nodeCount, std::size_t place = 0)
      : nodeCount_(nodeCount), lead_(kBlockNodes + 3 * place * kShift) {
    for (auto& array : arrays_) array.assign(paddedCount(nodeCount) + lead_ + 2 * kShift + kBlockNodes, 0.0);
  }

  static std::size_t paddedCount(std::size_t nodeCount) {
    return (nodeCount + kBlockNodes - 1) / kBlockNodes * kBlockNodes;
  }

  std::size_t size() const { return nodeCount_; }
  /// Null where there are no nodes.
  double* axis(std::size_t k) {
    return arrays_[k].empty() ? nullptr : arrays_[k].data() + lead_ + k * kShift;
  }
  const double* axis(std::size_t k) const {
    return arrays_[k].empty() ? nullptr : arrays_[k].data() + lead_ + k * kShift;
  }

  Vec3 get(std::size_t node) const { return {axis(0)[node], axis(1)[node], axis(2)[node]}; }
  void set(std::size_t node, const Vec3& value) {
    for (std::size_t k = 0; k < 3; ++k) axis(k)[node] = value[static_cast<Eigen::Index>(k)];
  }
  void add(std::size_t node, const Vec3& value) {
    for (std::size_t k = 0; k < 3; ++k) axis(k)[node] += value[static_cast<Eigen::Index>(k)];
  }
  std::size_t memoryBytes() const { return 3 * arrays_[0].capacity() * sizeof(double); }

 private:
  static constexpr std::size_t kShift = 5 * 64 / sizeof(double);  ///< five lines, in numbers

  std::size_t nodeCount_ = 0;
  std::size_t lead_ = 0;  ///< before the first node
  std::array<AlignedVector<double>, 3> arrays_;
};

/// Light moves at 3e10 cm/s, and nothing faster: stopping there keeps all energies finite in what is kept.
inline constexpr double kLightSpeedSquared = 9e20;

/// Positions at one time and velocities, which for velocity Verlet are half a step behind
/// (sim/methods/leapfrog.h).
struct Motion {
  NodeVectors position;
  NodeVectors velocity;
};

}  // namespace sim
