#include "sim/contact/start_depths.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace sim {
namespace {

/// Cosine: what goes out within 60 degrees of the way that most go goes the same way.
constexpr double kSameWay = 0.5;
/// Of all depths of a fragment in a collider, so much must add up to one way.
constexpr double kOneWay = 0.7;
/// Of the way out: if on it some node gets deeper into something by more, there is no such way.
constexpr double kDeeper = 0.1;

double depthIn(const MovingCollider& collider, const Vec3& point) {
  return collider.active ? std::max(0.0, intrusion(collider.shape, point).depth) : 0.0;
}

}  // namespace

std::pair<NodeIndex, std::uint32_t> StartDepths::placeOf(const Depth& depth) {
  return {depth.node, depth.collider};
}

bool StartDepths::isPushed(const Depth& depth, const Vec3& normal) {
  return normal.dot(depth.wayOut()) > kSameWay;
}

double StartDepths::depthAt(const Depth& depth, double time) {
  return std::max(0.0, depth.depth - kSpeed * (time - depth.since));
}

StartDepths::Surface StartDepths::of(NodeIndex node, std::uint32_t collider, const Vec3& normal,
                                     double time) const {
  if (depths_.empty()) return {};
  const auto found = std::ranges::lower_bound(depths_, std::pair(node, collider), {}, placeOf);
  if (found == depths_.end() || placeOf(*found) != std::pair(node, collider)) return {};
  if (!isPushed(*found, normal)) return {std::numeric_limits<double>::infinity(), 0.0};
  const double left = depthAt(*found, time);
  return left > 0.0 ? Surface{left, kSpeed} : Surface{};
}

namespace {

/// Where a fragment is to go out of a collider.
struct Way {
  Vec3 sum = Vec3::Zero();
  double depths = 0.0;
  double deepest = 0.0;  ///< cm
  bool open = false;     ///< it can go there

  bool isOne() const { return sum.norm() > kOneWay * depths; }
  Vec3 move() const { return deepest * sum.normalized(); }
};
using Ways = std::map<std::pair<FragmentId, std::uint32_t>, Way>;

std::set<FragmentId> heldFragments(const StartDepths::Scene& scene) {
  std::set<FragmentId> held;
  const std::vector<double>& masses = scene.model.network().masses;
  for (NodeIndex node = 0; node < masses.size(); ++node) {
    if (!std::isfinite(masses[node])) held.insert(scene.components.of(node));
  }
  return held;
}

/// Whether a fragment, moved so, would get no deeper into anything. What stands across a thin wall, or
/// between two walls, would.
bool mayMove(const StartDepths::Scene& scene, FragmentId fragment, const Vec3& move) {
  const double most = kDeeper * move.norm();
  for (NodeIndex node = 0; node < scene.positions.size(); ++node) {
    if (scene.components.of(node) != fragment) continue;
    const Vec3 here = scene.positions.get(node);
    for (const MovingCollider& collider : scene.colliders) {
      const double after = depthIn(collider, here + move);
      if (after > most && after > depthIn(collider, here) + most) return false;
    }
  }
  return true;
}

}  // namespace

void StartDepths::begin(const Scene& scene, std::span<const NodeAtCollider> near,
                        std::span<const MovingCollider> before) {
  std::vector<Depth> begun;
  Ways ways;
  for (const auto& [node, c] : near) {
    const MovingCollider& collider = scene.colliders[c];
    const double mass = scene.model.network().masses[node];
    if (!collider.active || !std::isfinite(mass)) continue;
    const Vec3 here = scene.positions.get(node);
    const Intrusion inside = intrusion(collider.shape, here);
    const double known = of(node, c, inside.normal, scene.time).depth;
    const double pressed = c < before.size() ? depthIn(before[c], here) : 0.0;
    const double more = inside.depth - std::max(known, pressed);
    const double rate = std::sqrt(scene.model.unscaledStiffness(node, collider.shape) / mass);
    if (!(more * rate > kSpeed)) continue;
    begun.push_back({known + more, scene.time, {}, node, c});
    Way& way = ways[{scene.components.of(node), c}];
    way.sum += more * inside.normal;
    way.depths += more;
    way.deepest = std::max(way.deepest, more);
  }
  if (begun.empty()) return;
  const std::set<FragmentId> held = heldFragments(scene);
  for (auto& [place, way] : ways) {
    const FragmentId fragment = place.first;
    way.open = way.isOne() && !held.contains(fragment) && mayMove(scene, fragment, way.move());
  }
  for (Depth& depth : begun) {
    const Way& way = ways.at({scene.components.of(depth.node), depth.collider});
    if (!way.open) continue;
    const Vec3 out = way.sum.normalized();
    depth.way = {out.x(), out.y(), out.z()};
  }
  // What begins anew comes first where something had begun already.
  begun.insert(begun.end(), depths_.begin(), depths_.end());
  std::ranges::stable_sort(begun, {}, placeOf);
  begun.erase(
      std::unique(begun.begin(), begun.end(),
                  [](const Depth& left, const Depth& right) { return placeOf(left) == placeOf(right); }),
      begun.end());
  depths_ = std::move(begun);
}

void StartDepths::follow(const NodeVectors& positions, std::span<const MovingCollider> colliders,
                         double time) {
  std::erase_if(depths_, [&](Depth& depth) {
    const MovingCollider& collider = colliders[depth.collider];
    const Intrusion inside = intrusion(collider.shape, positions.get(depth.node));
    if (!collider.active || inside.depth <= 0.0) return true;
    if (isPushed(depth, inside.normal)) return depthAt(depth, time) == 0.0;
    depth.depth = inside.depth;
    depth.since = time;
    return false;
  });
}

void StartDepths::save(ByteWriter& writer) const {
  writer.putVector(depths_);
}

bool StartDepths::load(ByteReader& reader, std::size_t nodeCount, std::size_t colliderCount) {
  if (!reader.readVector(depths_)) return false;
  const auto proper = [&](const Depth& depth) {
    return depth.node < nodeCount && depth.collider < colliderCount && std::isfinite(depth.depth) &&
           std::isfinite(depth.since);
  };
  return std::ranges::all_of(depths_, proper) || reader.fail();
}

}  // namespace sim
