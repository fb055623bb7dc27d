#pragma once

#include <functional>
#include <optional>

#include <Eigen/Geometry>

#include "sim/base/types.h"

namespace modeling {

/// Looks for a short move, cm, after which isFree() says yes: along `wayOut` (unit), up, down and sideways,
/// by `depth` (cm, > 0) and some multiples of it, and by what takes the box `moved` past the box `still`.
/// Shorter moves are tried first. An empty box has no such way. Nothing where none of these helps.
std::optional<sim::Vec3> shortEscape(double depth, const sim::Vec3& wayOut, const Eigen::AlignedBox3d& moved,
                                     const Eigen::AlignedBox3d& still,
                                     const std::function<bool(const sim::Vec3&)>& isFree);

}  // namespace modeling
