#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Geometry>

#include "sim/base/types.h"

namespace modeling {

/// Which small boxes of a large one something may reach into: says of most points in a moment that nothing is
/// there.
class Occupancy {
 public:
  /// Nothing is anywhere. `edge` is that of a small box, cm; a side of the large one is cut into kMostAlong
  /// at most.
  Occupancy(const Eigen::AlignedBox3d& whole, double edge);
  static constexpr int kMostAlong = 256;

  /// Something is within this box, which is within the large one.
  void add(const Eigen::AlignedBox3d& box);
  /// False: nothing is there.
  bool at(const sim::Vec3& point) const { return whole_.contains(point) && taken_[placeOf(stepsOf(point))]; }

 private:
  using Steps = std::array<std::size_t, 3>;
  Steps stepsOf(const sim::Vec3& point) const;
  std::size_t placeOf(const Steps& steps) const {
    return (steps[0] * count_[1] + steps[1]) * count_[2] + steps[2];
  }

  Eigen::AlignedBox3d whole_;
  Steps count_{1, 1, 1};
  sim::Vec3 stepsPerCm_ = sim::Vec3::Zero();
  std::vector<bool> taken_;
};

}  // namespace modeling
