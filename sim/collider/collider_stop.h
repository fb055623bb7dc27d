#pragma once

#include "sim/collider/moving_collider.h"

namespace sim {

/// Of a node that sets out from `here` with `velocity` (cm/s) for `step` seconds: the velocity that keeps it
/// from going deeper into the collider than deepest(), or than it is. Springs alone cannot promise that: a
/// fast node, or one that much presses on, goes through a thin sheet however stiff they are.
///
/// All of its way is looked at, so that no step is too long. What would take it too deep is taken off the
/// velocity along the collider's normal there, and friction with it across; where that does not help, it goes
/// only as far along its way as it may. Relative to the collider it never gets faster. `near` is as in
/// intrusion().
Vec3 stoppedVelocity(const MovingCollider& collider, const Vec3& here, const Vec3& velocity, double step,
                     std::uint32_t near = kNone);

}  // namespace sim
