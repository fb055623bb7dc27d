#include "sim/contact/surface_search.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "sim/contact/box_grid.h"
#include "sim/contact/closest_point.h"

namespace sim {
namespace {

/// Of the lesser radius: so far apart do surfaces stay.
constexpr double kThickness = 0.02;
/// Of its radius: how large a loose node is.
constexpr double kLooseSize = 0.4;
/// Edges that are bent by less than this (cosine) are met by faces well enough.
constexpr double kSharp = 0.94;

Eigen::AlignedBox3d boxOf(std::span<const NodeIndex> nodes, const NodeVectors& positions) {
  Eigen::AlignedBox3d box;
  for (const NodeIndex node : nodes) box.extend(positions.get(node));
  return box;
}

bool isSharp(const Outside& outside, const OutsideEdge& edge, const NodeVectors& positions) {
  const OutsideTriangle& one = outside.triangles()[edge.triangles[0]];
  const OutsideTriangle& two = outside.triangles()[edge.triangles[1]];
  const Vec3 normal = normalOf(one, positions);
  if (normal.dot(normalOf(two, positions)) > kSharp) return false;
  for (const NodeIndex node : two.nodes) {
    if (node != edge.nodes[0] && node != edge.nodes[1])
      return normal.dot(positions.get(node) - positions.get(edge.nodes[0])) < 0.0;
  }
  return false;
}

double squaredGap(const SurfaceScene& scene, NodeIndex node, const OutsideTriangle& triangle) {
  const Vec3 point = scene.positions.get(node);
  const Vec3 a = scene.positions.get(triangle.nodes[0]);
  const Vec3 b = scene.positions.get(triangle.nodes[1]);
  const Vec3 c = scene.positions.get(triangle.nodes[2]);
  const Vec3 weights = closestOnTriangle(point, a, b, c).weights;
  return (weights[0] * a + weights[1] * b + weights[2] * c - point).squaredNorm();
}

bool mayMeet(const ContactModel& model, const SurfaceScene& scene, NodeIndex a, NodeIndex b) {
  return model.settings().between && scene.components.of(a) != scene.components.of(b) &&
         model.maySpring(a, b);
}

double squaredBetween(const SurfaceScene& scene, const OutsideEdge& one, const OutsideEdge& two) {
  const Vec3 a0 = scene.positions.get(one.nodes[0]);
  const Vec3 a1 = scene.positions.get(one.nodes[1]);
  const Vec3 b0 = scene.positions.get(two.nodes[0]);
  const Vec3 b1 = scene.positions.get(two.nodes[1]);
  const ClosestOfEdges closest = closestOfEdges(a0, a1, b0, b1);
  if (closest.parallel) return 0.0;
  const double s = std::clamp(closest.s, 0.0, 1.0);
  const double t = std::clamp(closest.t, 0.0, 1.0);
  return (a0 + s * (a1 - a0) - b0 - t * (b1 - b0)).squaredNorm();
}

}  // namespace

double reachOf(const ContactModel& model, NodeIndex a, NodeIndex b) {
  return kThickness * static_cast<double>(std::min(model.network().radii[a], model.network().radii[b]));
}

double looseReach(const ContactModel& model, const Outside& outside, NodeIndex node) {
  return outside.isLoose(node) ? kLooseSize * static_cast<double>(model.network().radii[node]) : 0.0;
}

double largestSurfaceReach(const ContactModel& model) {
  return (kThickness + kLooseSize) * model.largestNatural();
}

void findSurfaceRows(const ContactModel& model, const SurfaceScene& scene, SurfaceRows& found) {
  SurfaceRows before = std::move(found);
  found = {};
  const Outside& outside = scene.outside;
  const double skin = model.pairSkin();
  const double widest = largestSurfaceReach(model) + skin;
  const std::vector<FragmentBoxes::Box> meetings = scene.boxes.meetings(widest * (1.0 + 1e-9));
  const auto meets = [&](std::span<const NodeIndex> nodes) {
    const FragmentBoxes::Box& box = meetings[scene.components.of(nodes[0])];
    if (box.isEmpty()) return false;
    return box.intersects(boxOf(nodes, scene.positions));
  };
  BoxGrid faces(2.0 * model.largestNatural());
  BoxGrid sharp(2.0 * model.largestNatural());
  bool anyFace = false;
  for (std::uint32_t t = 0; t < outside.triangles().size(); ++t) {
    const OutsideTriangle& triangle = outside.triangles()[t];
    if (!meets(triangle.nodes)) continue;
    faces.add(t, scene.components.of(triangle.nodes[0]), boxOf(triangle.nodes, scene.positions));
    anyFace = true;
  }
  if (!anyFace) return;
  std::vector<std::uint32_t> edges;
  for (std::uint32_t e = 0; e < outside.edges().size(); ++e) {
    const OutsideEdge& edge = outside.edges()[e];
    if (!meets(edge.nodes) || !isSharp(outside, edge, scene.positions)) continue;
    sharp.add(e, scene.components.of(edge.nodes[0]), boxOf(edge.nodes, scene.positions));
    edges.push_back(e);
  }
  faces.sort();
  sharp.sort();
  std::vector<std::uint32_t> nearby;
  const auto widened = [](Eigen::AlignedBox3d box, double by) {
    box.min().array() -= by;
    box.max().array() += by;
    return box;
  };
  const double thickest = kThickness * model.largestNatural();
  for (NodeIndex node = 0; node < model.network().nodeCount(); ++node) {
    if (!outside.isLoose(node) && !outside.isOutside(node)) continue;
    const FragmentBoxes::Box& box = meetings[scene.components.of(node)];
    const Vec3 point = scene.positions.get(node);
    if (box.isEmpty() || !box.contains(point)) continue;
    SurfaceRow row;
    row.which = node;
    row.first = static_cast<std::uint32_t>(found.near.size());
    const double base = looseReach(model, outside, node) + skin;
    faces.find(scene.components.of(node), widened(Eigen::AlignedBox3d(point), base + thickest), 0, nearby);
    for (const std::uint32_t t : nearby) {
      const OutsideTriangle& triangle = outside.triangles()[t];
      if (!mayMeet(model, scene, node, triangle.nodes[0])) continue;
      const double reach = base + reachOf(model, node, triangle.nodes[0]);
      if (squaredGap(scene, node, triangle) < reach * reach) found.near.push_back(t);
    }
    row.last = static_cast<std::uint32_t>(found.near.size());
    if (row.first != row.last) found.rows.push_back(row);
  }
  for (const std::uint32_t e : edges) {
    SurfaceRow row;
    row.which = e;
    row.isEdge = true;
    row.first = static_cast<std::uint32_t>(found.near.size());
    const OutsideEdge& edge = outside.edges()[e];
    sharp.find(scene.components.of(edge.nodes[0]),
               widened(boxOf(edge.nodes, scene.positions), skin + thickest), e + 1, nearby);
    for (const std::uint32_t other : nearby) {
      const OutsideEdge& two = outside.edges()[other];
      if (!mayMeet(model, scene, edge.nodes[0], two.nodes[0])) continue;
      const double reach = skin + reachOf(model, edge.nodes[0], two.nodes[0]);
      if (squaredBetween(scene, edge, two) < reach * reach) found.near.push_back(other);
    }
    row.last = static_cast<std::uint32_t>(found.near.size());
    if (row.first != row.last) found.rows.push_back(row);
  }
  found.clearUntil.assign(found.rows.size(), 0.0);
  found.farUntil.assign(found.near.size(), 0.0);
  // Contacts find their rows again by node or by edge; what they name may have got another number.
  std::unordered_map<std::uint64_t, std::uint32_t> rowOf;
  const auto edgeKey = [](NodeIndex a, NodeIndex b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32U) | std::max(a, b);
  };
  for (std::uint32_t r = 0; r < found.rows.size(); ++r) {
    const SurfaceRow& row = found.rows[r];
    if (row.isEdge) {
      const OutsideEdge& edge = outside.edges()[row.which];
      rowOf[edgeKey(edge.nodes[0], edge.nodes[1])] = r;
    } else {
      rowOf[edgeKey(row.which, row.which)] = r;
    }
  }
  std::vector<SurfaceContact> kept;
  for (SurfaceContact contact : before.contacts) {
    const auto place = rowOf.find(contact.crossing() ? edgeKey(contact.nodes[0], contact.nodes[1])
                                                     : edgeKey(contact.nodes[0], contact.nodes[0]));
    if (place == rowOf.end()) continue;
    contact.row = place->second;
    kept.push_back(contact);
  }
  std::stable_sort(kept.begin(), kept.end(), [](const SurfaceContact& left, const SurfaceContact& right) {
    return left.row < right.row;
  });
  found.contacts = std::move(kept);
  found.index();
}

}  // namespace sim
