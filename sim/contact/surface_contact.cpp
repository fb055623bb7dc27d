#include "sim/contact/surface_contact.h"

#include <cmath>

#include "sim/contact/closest_point.h"

namespace sim {
namespace {

struct Corners {
  Vec3 a, b, c;
};

Corners cornersOf(const SurfaceContact& contact, const NodeVectors& positions) {
  return {positions.get(contact.nodes[1]), positions.get(contact.nodes[2]), positions.get(contact.nodes[3])};
}

/// Of the foot of the perpendicular on the plane of the triangle, which may lie outside of it.
Vec3 weightsInPlane(const Vec3& point, const Corners& at) {
  const Vec3 ab = at.b - at.a;
  const Vec3 ac = at.c - at.a;
  const Vec3 ap = point - at.a;
  const double bb = ab.squaredNorm();
  const double bc = ab.dot(ac);
  const double cc = ac.squaredNorm();
  const double pb = ap.dot(ab);
  const double pc = ap.dot(ac);
  const double across = bb * cc - bc * bc;
  const double v = (cc * pb - bc * pc) / across;
  const double w = (bb * pc - bc * pb) / across;
  return {1.0 - v - w, v, w};
}

SurfaceGap faceGap(const Vec3& point, const Corners& at) {
  const Vec3 weights = weightsInPlane(point, at);
  SurfaceGap found;
  found.weights = {1.0, -weights[0], -weights[1], -weights[2]};
  found.normal = (at.b - at.a).cross(at.c - at.a).normalized();
  found.gap = found.normal.dot(point - at.a);
  return found;
}

/// Of an edge or a corner.
SurfaceGap roundGap(const SurfaceContact& contact, const Vec3& point, const Corners& at) {
  const std::array<Vec3, 3> corners{at.a, at.b, at.c};
  std::array<std::size_t, 2> ends{};
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if ((contact.corners >> i & 1U) != 0) ends[count++] = i;
  }
  double along = 0.0;
  if (count == 2) {
    const Vec3 edge = corners[ends[1]] - corners[ends[0]];
    along = edge.dot(point - corners[ends[0]]) / edge.squaredNorm();
  }
  SurfaceGap found;
  found.weights[0] = 1.0;
  found.weights[1 + ends[0]] = -(1.0 - along);
  if (count == 2) found.weights[1 + ends[1]] = -along;
  Vec3 apart = point - corners[ends[0]];
  if (count == 2) apart -= along * (corners[ends[1]] - corners[ends[0]]);
  const double distance = apart.norm();
  found.normal = distance > 0.0 ? Vec3(contact.sign / distance * apart) : Vec3::Zero();
  found.gap = contact.sign * distance;
  return found;
}

SurfaceGap crossingGap(const SurfaceContact& contact, const NodeVectors& positions) {
  const Vec3 a0 = positions.get(contact.nodes[0]);
  const Vec3 a1 = positions.get(contact.nodes[1]);
  const Vec3 b0 = positions.get(contact.nodes[2]);
  const Vec3 b1 = positions.get(contact.nodes[3]);
  const ClosestOfEdges closest = closestOfEdges(a0, a1, b0, b1);
  SurfaceGap found;
  if (closest.parallel) return found;
  found.weights = {1.0 - closest.s, closest.s, -(1.0 - closest.t), -closest.t};
  found.normal = contact.sign * (a1 - a0).cross(b1 - b0).normalized();
  found.gap = found.normal.dot(a0 - b0);
  return found;
}

}  // namespace

SurfaceGap gapOf(const SurfaceContact& contact, const NodeVectors& positions) {
  if (contact.crossing()) return crossingGap(contact, positions);
  const Vec3 point = positions.get(contact.nodes[0]);
  const Corners at = cornersOf(contact, positions);
  return contact.corners == 7U ? faceGap(point, at) : roundGap(contact, point, at);
}

Vec3 weightedSum(const std::array<double, 4>& weights, const std::array<NodeIndex, 4>& nodes,
                 const NodeVectors& vectors) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < 4; ++i) sum += weights[i] * vectors.get(nodes[i]);
  return sum;
}

Vec3 tangentialStretch(const SurfaceContact& contact, const SurfaceGap& gap, const NodeVectors& positions) {
  const Vec3 stretch = weightedSum(contact.anchor, contact.nodes, positions);
  return stretch - gap.normal.dot(stretch) * gap.normal;
}

void anchorAt(SurfaceContact& contact, const SurfaceGap& gap, const Vec3& stretch,
              const NodeVectors& positions) {
  contact.anchored = 1;
  if (contact.crossing()) {
    const Vec3 u = positions.get(contact.nodes[1]) - positions.get(contact.nodes[0]);
    const Vec3 v = positions.get(contact.nodes[3]) - positions.get(contact.nodes[2]);
    const double uu = u.squaredNorm();
    const double uv = u.dot(v);
    const double vv = v.squaredNorm();
    const double across = uu * vv - uv * uv;
    const double du = (vv * stretch.dot(u) - uv * stretch.dot(v)) / across;
    const double dv = (uv * stretch.dot(u) - uu * stretch.dot(v)) / across;
    const double s = gap.weights[1] + du;
    const double t = -gap.weights[3] + dv;
    contact.anchor = {1.0 - s, s, -(1.0 - t), -t};
    return;
  }
  // Beside the triangle, too, nothing is stretched where the anchor is the point of contact.
  const Vec3 point = positions.get(contact.nodes[0]);
  const Corners at = cornersOf(contact, positions);
  const Vec3 shift = weightsInPlane(point, at) - weightsInPlane(point - stretch, at);
  contact.anchor = gap.weights;
  for (std::size_t i = 0; i < 3; ++i) contact.anchor[i + 1] += shift[static_cast<Eigen::Index>(i)];
}

}  // namespace sim
