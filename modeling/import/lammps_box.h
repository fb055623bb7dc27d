#pragma once

#include <array>

#include <Eigen/Core>

#include "sim/base/types.h"

namespace modeling {

/// The box of LAMMPS, a parallelepiped, which repeats itself where it is periodic.
struct LammpsBox {
  sim::Vec3 origin = sim::Vec3::Zero();                 ///< its corner
  Eigen::Matrix3d edges = Eigen::Matrix3d::Identity();  ///< a, b and c, a column each
  std::array<bool, 3> periodic{false, false, false};    ///< along a, b and c, where a file says so

  /// "xlo xhi", "ylo yhi", "zlo zhi" and "xy xz yz".
  static LammpsBox ofBounds(const sim::Vec3& low, const sim::Vec3& high, const sim::Vec3& tilt);
  /// As dumps have them: the bounds of all corners of a box that is tilted.
  static LammpsBox ofOuterBounds(const sim::Vec3& low, const sim::Vec3& high, const sim::Vec3& tilt);

  /// Whether it holds anything at all.
  bool hasVolume() const;
  /// A vector, in edges of the box; it must have a volume.
  sim::Vec3 inEdges(const sim::Vec3& vector) const;
  /// What of a vector goes by whole boxes, along each edge that `along` names.
  sim::Vec3 wholeBoxes(const sim::Vec3& vector, const std::array<bool, 3>& along) const;
};

}  // namespace modeling
