#pragma once

#include <variant>

#include <Eigen/Geometry>

#include "sim/base/types.h"

/// Where things of a scene are.
namespace modeling {

using sim::Vec3;

/// As written: degrees about the fixed axes x, then y, then z; or a quaternion w, x, y, z of any length above
/// 0.
struct Rotation {
  std::variant<Vec3, Eigen::Vector4d> value = Vec3(Vec3::Zero());

  Eigen::Quaterniond quaternion() const;
  bool operator==(const Rotation&) const = default;
};

/// One factor for all axes, or one an axis; each above 0, because a mirrored cell is turned inside out.
struct Scale {
  Vec3 factors = Vec3::Ones();

  bool operator==(const Scale&) const = default;
};

/// worldFromPart: scale first, then rotation, then position.
struct Placement {
  Vec3 position = Vec3::Zero();  ///< cm
  Rotation rotation;
  Scale scale;

  Eigen::Affine3d worldFromPart() const;
  bool operator==(const Placement&) const = default;
};

struct Box {
  Vec3 min = Vec3::Zero();  ///< cm
  Vec3 max = Vec3::Zero();  ///< cm, not below min on any axis

  bool operator==(const Box&) const = default;
};

}  // namespace modeling
