#include "sim/contact/start_depths.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace sim {
namespace {

/// Cosine: what goes out within 60 degrees of the way that most go goes the same way.
constexpr double kSameWay = 0.5;

double depthIn(const MovingCollider& collider, const Vec3& point) {
  return collider.active ? std::max(0.0, intrusion(collider.shape, point).depth) : 0.0;
}

}  // namespace

std::pair<NodeIndex, std::uint32_t> StartDepths::placeOf(const Depth& depth) {
  return {depth.node, depth.collider};
}

StartDepths::Surface StartDepths::surfaceOf(const Depth& depth, double time) {
  if (depth.pushes == 0) return {depth.depth, 0.0};
  const double left = depth.depth - kSpeed * (time - depth.since);
  return left > 0.0 ? Surface{left, kSpeed} : Surface{};
}

StartDepths::Surface StartDepths::of(NodeIndex node, std::uint32_t collider, double time) const {
  if (depths_.empty()) return {};
  const auto found = std::ranges::lower_bound(depths_, std::pair(node, collider), {}, placeOf);
  const bool begun = found != depths_.end() && placeOf(*found) == std::pair(node, collider);
  return begun ? surfaceOf(*found, time) : Surface{};
}

void StartDepths::begin(const Scene& scene, std::span<const NodeAtCollider> near,
                        std::span<const MovingCollider> before) {
  std::vector<Depth> begun;
  std::vector<Vec3> waysOut;
  std::map<std::pair<FragmentId, std::uint32_t>, Vec3> mostGo;
  for (const auto& [node, c] : near) {
    const MovingCollider& collider = scene.colliders[c];
    const double mass = scene.model.network().masses[node];
    if (!collider.active || !std::isfinite(mass)) continue;
    const Vec3 here = scene.positions.get(node);
    const Intrusion inside = intrusion(collider.shape, here);
    const double known = of(node, c, scene.time).depth;
    const double pressed = c < before.size() ? depthIn(before[c], here) : 0.0;
    const double more = inside.depth - std::max(known, pressed);
    const double rate = std::sqrt(scene.model.unscaledStiffness(node, collider.shape) / mass);
    if (!(more * rate > kSpeed)) continue;
    begun.push_back({known + more, scene.time, node, c, 1});
    waysOut.push_back(inside.normal);
    mostGo.try_emplace({scene.components.of(node), c}, Vec3::Zero()).first->second += more * inside.normal;
  }
  for (std::size_t i = 0; i < begun.size(); ++i) {
    const Vec3& way = mostGo.at({scene.components.of(begun[i].node), begun[i].collider});
    begun[i].pushes = waysOut[i].dot(way) > kSameWay * way.norm() ? 1 : 0;
  }
  // What begins anew comes first where something had begun already.
  begun.insert(begun.end(), depths_.begin(), depths_.end());
  std::ranges::stable_sort(begun, {}, placeOf);
  const auto repeated = std::ranges::unique(begun, {}, placeOf);
  begun.erase(repeated.begin(), repeated.end());
  depths_ = std::move(begun);
}

void StartDepths::forgetPast(const NodeVectors& positions, std::span<const MovingCollider> colliders,
                             double time) {
  std::erase_if(depths_, [&](Depth& depth) {
    const double now = depthIn(colliders[depth.collider], positions.get(depth.node));
    if (depth.pushes == 0) depth.depth = std::min(depth.depth, now);
    return now == 0.0 || surfaceOf(depth, time).depth == 0.0;
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
