#pragma once

#include <cstddef>
#include <vector>

#include "modeling/exchange/rigid_fit.h"

namespace modeling {

/// Which frames are needed as keys so that straight interpolation between them is nowhere (at the frames) off
/// by more than the tolerance, cm. Ascending, with the first and the last; only the first where nothing moves
/// further than the tolerance from there. (Douglas and Peucker 1973.)
std::vector<std::size_t> positionKeys(const std::vector<Pose>& poses, double tolerance);

/// The same for rotations, of a piece whose points are within `radius` (cm) of its origin. Keeps to the
/// tolerance for programs that interpolate along the sphere, as glTF says, and for those that interpolate the
/// four components and normalise, as Blender does.
std::vector<std::size_t> rotationKeys(const std::vector<Pose>& poses, double radius, double tolerance);

}  // namespace modeling
