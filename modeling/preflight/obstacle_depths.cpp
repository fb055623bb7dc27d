#include "modeling/preflight/obstacle_depths.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <mutex>

#include "sim/base/parallel.h"

namespace modeling {
namespace {

constexpr double kRounding = 1e-3;       // of a node's radius
constexpr double kLeastRounding = 1e-7;  // cm
constexpr double kMostAlong = 200.0;     // points along an edge of an obstacle's drawing

std::uint32_t pointsAlong(double length, double spacing) {
  return static_cast<std::uint32_t>(std::clamp(std::ceil(length / spacing), 1.0, kMostAlong));
}

}  // namespace

std::vector<NodeInside> deepestNodes(const sim::Network& network, const sim::Collider& obstacle,
                                     const NodeLook& look) {
  constexpr std::size_t kGrain = 4096;
  std::vector<NodeInside> deepest(network.partNames.size());
  const double reach = sim::reachOf(obstacle);
  std::mutex merging;
  std::atomic<bool> enough{false};
  sim::parallelRanges(network.nodeCount(), kGrain, sim::Sharing::balanced,
                      [&](std::size_t begin, std::size_t end) {
                        std::vector<NodeInside> here(deepest.size());
                        std::uint32_t near = sim::kNone;
                        for (std::size_t node = begin; node < end && !enough; ++node) {
                          const sim::PartIndex part = network.nodeParts[node];
                          if (!look.only.empty() && look.only[part] == 0) continue;
                          const Vec3 at = network.positions[node] + look.move;
                          if (!std::isfinite(network.masses[node]) || (at - obstacle.position).norm() > reach)
                            continue;
                          const sim::Intrusion inside = sim::intrusion(obstacle, at, near);
                          near = inside.nearest;
                          const double rounding =
                              std::max(kRounding * static_cast<double>(network.radii[node]), kLeastRounding);
                          if (inside.depth <= rounding || inside.depth <= here[part].depth) continue;
                          here[part] = {inside.depth, static_cast<sim::NodeIndex>(node), inside.normal};
                          if (look.any) enough = true;
                        }
                        const std::lock_guard lock(merging);
                        for (std::size_t part = 0; part < here.size(); ++part) {
                          const NodeInside& found = here[part];
                          NodeInside& best = deepest[part];
                          if (found.depth > best.depth ||
                              (found.depth > 0.0 && found.depth == best.depth && found.node < best.node))
                            best = found;
                        }
                      });
  return deepest;
}

PartSolid::Inside deepestPoint(const sim::Collider& obstacle, const PartSolid& part, double tolerance) {
  PartSolid::Inside deepest;
  const sim::ColliderSurface surface = sim::surfaceOf(obstacle);
  std::uint32_t near = sim::kNone;
  for (const auto& quad : surface.quads) {
    std::array<Vec3, 4> corners;
    Eigen::AlignedBox3d box;
    for (std::size_t c = 0; c < 4; ++c) {
      corners[c] = obstacle.position + obstacle.rotation * surface.points[quad[c]];
      box.extend(corners[c]);
    }
    if (!box.intersects(part.box())) continue;
    const auto longer = [&](std::size_t a, std::size_t b, std::size_t c, std::size_t d) {
      return std::max((corners[b] - corners[a]).norm(), (corners[d] - corners[c]).norm());
    };
    const std::uint32_t across = pointsAlong(longer(0, 1, 3, 2), 0.5 * part.edge());
    const std::uint32_t along = pointsAlong(longer(0, 3, 1, 2), 0.5 * part.edge());
    for (std::uint32_t i = 0; i <= across; ++i) {
      for (std::uint32_t j = 0; j <= along; ++j) {
        const double u = static_cast<double>(i) / across, v = static_cast<double>(j) / along;
        const Vec3 point = (1.0 - v) * ((1.0 - u) * corners[0] + u * corners[1]) +
                           v * ((1.0 - u) * corners[3] + u * corners[2]);
        const auto found = part.inside(point, tolerance, near);
        if (found && found->depth > deepest.depth) deepest = *found;
      }
    }
  }
  return deepest;
}

}  // namespace modeling
