#pragma once

#include "modeling/shapes/sheet.h"
#include "modeling/shapes/wall_profile.h"

namespace modeling {

/// How a wall that meets the axis is divided along its spine: where the discs end, how many rings they have,
/// how many rows of cells lie between. A disc reaches to where the spine bends away from the axis' normal (a
/// cup: the foot of its wall; a ball: 45 degrees), since a disc's cells are good only where it is nearly
/// flat; its rings make its cells as long outwards as they are wide at its edge.
sim::Result<TurnedLayout> planTurned(const WallProfile& profile, const RevolutionShape& shape,
                                     int cellsAround);

}  // namespace modeling
