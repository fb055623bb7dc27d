#include "sim/collider/collider_stop.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace sim {
namespace {

/// Of deepest(): a way is looked at in hops of at least so much, and may end so much beyond, that a node
/// that grazes the limit does not take thousands of looks.
constexpr double kHopShare = 0.05;
/// A way that is not looked through by then ends there.
constexpr int kMostLooks = 256;
/// One time for each wall of a corner, and one more.
constexpr int kMostStops = 4;

struct Stop {
  double share = 0.0;  ///< of the way that is not too deep
  Vec3 normal = Vec3::UnitZ();
};

/// Where a straight way gets too deep, if it does. Depth changes by no more than the way between two points,
/// so what is left to the limit may be gone without looking.
std::optional<Stop> findStop(const Collider& collider, const Vec3& from, const Vec3& way,
                             std::uint32_t near) {
  const double length = way.norm();
  if (!(length > 0.0)) return std::nullopt;
  const double hop = kHopShare * deepest(collider);
  double limit = deepest(collider) + hop;
  Stop stop;
  double share = 0.0;
  for (int look = 0; look < kMostLooks; ++look) {
    const Intrusion inside = intrusion(collider, from + share * way, near);
    near = inside.nearest;
    if (look == 0) limit = std::max(limit, inside.depth);
    stop.normal = inside.normal;
    if (inside.depth > limit) return stop;
    stop.share = share;
    if (share >= 1.0) return std::nullopt;
    share = std::min(1.0, share + std::max(limit - inside.depth, hop) / length);
  }
  return stop;
}

}  // namespace

Vec3 stoppedVelocity(const MovingCollider& collider, const Vec3& here, const Vec3& velocity, double step,
                     std::uint32_t near) {
  if (!std::isfinite(deepest(collider.shape))) return velocity;
  std::optional<Stop> stop =
      findStop(collider.shape, here, step * (velocity - collider.velocityAt(here)), near);
  if (!stop) return velocity;
  const Vec3 carried = collider.velocityAt(here);
  Vec3 relative = velocity - carried;
  for (int stops = 0; stop && stops < kMostStops; ++stops) {
    const double inward = -relative.dot(stop->normal);
    if (!(inward > 0.0)) break;
    const double taken = (1.0 - stop->share) * inward;
    const Vec3 slip = relative + inward * stop->normal;
    const double speed = slip.norm();
    relative += taken * stop->normal;
    if (speed > 0.0) relative -= std::min(1.0, collider.shape.friction * taken / speed) * slip;
    stop = findStop(collider.shape, here, step * relative, near);
  }
  if (stop) relative *= stop->share;
  return carried + relative;
}

}  // namespace sim
