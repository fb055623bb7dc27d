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

/// What is swept along the curve. Every section lies within first axis * halfWidth and second axis *
/// halfDepth.
enum class SweepSection {
  disc,       ///< the ellipse, solid
  rectangle,  ///< the rectangle, solid
  ring,       ///< the ellipse's wall: between it and the one whose half axes are smaller by wallThickness
  arc,        ///< the part of the ring from startAngle to endAngle: half a spout
};

/// A curved cylinder (paper, "Geometric modeling": handle and spout of the teapot): a section swept along a
/// chain of cubic Bezier segments.
///
/// The section's plane has a first and a second axis. With one curve it is perpendicular to the curve, which
/// passes through its centre; the first axis starts as near as may be to `firstAxis` and turns about the
/// curve no more than it must (rotation-minimising: double reflection, Wang et al. 2008), or with
/// `keepFirstAxis` is `firstAxis` made perpendicular to the curve everywhere. With a second curve of as many
/// segments the two are rails: the section is centred between points of equal Bezier parameter, its first
/// axis runs from the first rail to the second, half their distance being the half width (halfWidth is not
/// read), and its second axis is perpendicular to that and to the way the sweep goes. The teapot's handle and
/// spout are given so.
///
/// u runs along the curve, evenly spaced by length. disc and ring: v around, w outwards. rectangle: v along
/// the first axis, w along the second. arc: v from startAngle to endAngle, w outwards through the wall. disc:
/// cells around are a multiple of 8; cells outwards follow from them and are not read. Angles run from the
/// first axis towards the second.
struct CurvedCylinderShape {
  static constexpr std::string_view kName = "curvedCylinder";

  CurveChain curve;
  CurveChain secondRail;           ///< empty: `curve` is the centre line
  Vec3 firstAxis = Vec3::UnitY();  ///< not along the curve's start; not read with a second rail
  bool keepFirstAxis = false;
  SweepSection section = SweepSection::disc;
  ValueChain halfWidth =
      constantValue(0.5);  ///< cm, > 0, along the first axis; one segment a curve segment, or one for all
  ValueChain halfDepth = constantValue(0.5);  ///< cm, > 0, along the second axis; as many segments
  double wallThickness = 0.3;                 ///< cm; ring and arc: > 0 and less than both half axes
  double startAngle = 0.0;                    ///< rad; arc only
  double endAngle = std::numbers::pi;         ///< rad; arc only, startAngle < endAngle < startAngle + 2 pi
  Resolution resolution;

  /// Contains the solid, cm.
  Eigen::AlignedBox3d box() const;
  std::optional<double> cellEdge() const { return resolution.cellSize; }

  bool operator==(const CurvedCylinderShape&) const = default;
};

sim::Result<Lattice> build(const CurvedCylinderShape& shape);

}  // namespace modeling
