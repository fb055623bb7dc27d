#pragma once

#include <array>
#include <optional>
#include <string_view>

#include <Eigen/Geometry>

#include "modeling/shapes/lattice.h"
#include "modeling/shapes/resolution.h"
#include "sim/base/result.h"

namespace modeling {

/// Control net of a bicubic Bezier patch, cm: net[i][j] has i along u and j along v.
using ControlNet = std::array<std::array<Vec3, 4>, 4>;

/// On which side of its net a thickened patch lies. The net's normal is (d/du) x (d/dv).
enum class PatchSide {
  centred,  ///< half the thickness on each side
  outside,  ///< all of it on the side the normal points to
  inside,   ///< all of it on the other side
};

/// A thickened Bezier patch (paper, "Geometric modeling": "the solid formed by creating a lattice between two
/// parallel Bezier patches"). u and v are the patch's own, spaced by arc length along its middle lines; w
/// runs through the thickness, from the back to the front of the normal, or from `net` to `oppositeNet`.
struct BezierPatchShape {
  static constexpr std::string_view kName = "patch";

  ControlNet net{};
  std::optional<ControlNet>
      oppositeNet;         ///< where given, the solid lies between the two and thickness is not read
  double thickness = 0.4;  ///< cm, > 0; where the net bends more sharply, the solid would fold: a Problem
  PatchSide side = PatchSide::centred;
  Resolution resolution;

  /// Contains the solid, cm.
  Eigen::AlignedBox3d box() const;
  std::optional<double> cellEdge() const { return resolution.cellSize; }

  bool operator==(const BezierPatchShape&) const = default;
};

sim::Result<Lattice> build(const BezierPatchShape& shape);

}  // namespace modeling
