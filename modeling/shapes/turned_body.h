#pragma once

#include "modeling/shapes/wall_profile.h"

namespace modeling {

/// The solid body of a RevolutionShape whose inside profile lies on the axis: a stack of discs, wrapped in
/// layers of cells over every end that closes on the axis, so that no disc shrinks to a point
/// (docs/shapes.md). Not yet completed().
sim::Result<Lattice> buildTurnedBody(const WallProfile& profile, const RevolutionShape& shape,
                                     int cellsAround);

}  // namespace modeling
