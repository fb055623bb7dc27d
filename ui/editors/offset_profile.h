#pragma once

#include "modeling/shapes/revolution.h"
#include "sim/base/result.h"

namespace ui {

/// A wall of one thickness. The outside is the curve it was made from, with points added where the inside has
/// some, so that the two can correspond by segments.
struct OffsetWall {
  modeling::ProfileChain outside;
  modeling::ProfileChain inside;
  modeling::ProfileCorrespondence correspondence = modeling::ProfileCorrespondence::segments;
};

/// The side of a profile that faces the axis: 1 where it is on the left of the way it runs, else -1.
double insideOf(const modeling::ProfileChain& outside);

/// The inside profile at `thickness` (cm) from the outside, towards the axis. Every point of it is that far
/// from the outside, to about a hundredth; a corner, or a bend sharper than the wall is thick, becomes a
/// corner or an arc. It ends on the axis where the outside does. Problem: a thickness that is not above 0, or
/// that leaves nothing inside.
sim::Result<OffsetWall> offsetInside(const modeling::ProfileChain& outside, double thickness);

}  // namespace ui
