#pragma once

#include <numbers>
#include <optional>
#include <string_view>

#include <Eigen/Geometry>

#include "modeling/shapes/bezier.h"
#include "modeling/shapes/lattice.h"
#include "modeling/shapes/resolution.h"
#include "sim/base/result.h"

namespace modeling {

/// Which points of the two profiles face each other through the wall.
enum class ProfileCorrespondence {
  arcLength,  ///< equal shares of each profile's length; the profiles may have different numbers of segments
  segments,   ///< segment i faces segment i, by shares of their lengths; keeps a corner opposite its corner
};

/// The solid between an outside and an inside surface of revolution about the z axis (paper, "Geometric
/// modeling"). Both profiles are chains of (r, z), r >= 0, that run the same way (say from the rim to the
/// base). They must not cross or touch; at an end they may
///  - both stop off the axis: a rim, as wide as the wall is thick there;
///  - both stop on the axis: the wall closes over it (a cup's base, a lid's top) with a disc of cells in
///  place of the
///    wedges a polar grid would have there (docs/shapes.md).
/// Where the inside profile lies on the axis from end to end, the body is solid, and the outside profile may
/// stop on the axis or off it, where the body then has a flat or conical end.
///
/// u runs around, v along the profiles, w through the wall from the inside (0) to the outside (1).
/// A full turn shares the nodes of its first and last column: u is 0 there, and on the axis.
/// Cells around: at least 3; where the wall meets the axis or the body is solid, a multiple of twice the
/// number of sectors (a sector turns by at most 100 degrees: 4 in a full turn, so 8, 16, 24, ...).
/// Cells along: where the wall meets the axis, counted from it along the profile.
/// Cells through the wall: in a solid body, the layers that wrap around its closed ends, by default as many
/// as make its cells even; not read where both ends are open.
struct RevolutionShape {
  static constexpr std::string_view kName = "revolution";

  ProfileChain outside;
  ProfileChain inside;
  ProfileCorrespondence correspondence = ProfileCorrespondence::arcLength;
  double startAngle = 0.0;                    ///< rad, from x towards y
  double turnAngle = 2.0 * std::numbers::pi;  ///< rad, 0 < angle <= 2 pi
  Resolution resolution;

  /// Contains the solid, cm.
  Eigen::AlignedBox3d box() const;
  std::optional<double> cellEdge() const { return resolution.cellSize; }

  bool operator==(const RevolutionShape&) const = default;
};

sim::Result<Lattice> build(const RevolutionShape& shape);

}  // namespace modeling
