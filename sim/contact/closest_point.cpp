#include "sim/contact/closest_point.h"

namespace sim {
namespace {

/// Sine squared of the angle below which edges count as parallel: their ends meet the other's faces instead.
constexpr double kParallel = 1e-3;

}  // namespace

ClosestOnTriangle closestOnTriangle(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 ap = point - a;
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {{1.0, 0.0, 0.0}, 1U};
  const Vec3 bp = point - b;
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return {{0.0, 1.0, 0.0}, 2U};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double v = d1 / (d1 - d3);
    return {{1.0 - v, v, 0.0}, 3U};
  }
  const Vec3 cp = point - c;
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return {{0.0, 0.0, 1.0}, 4U};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double w = d2 / (d2 - d6);
    return {{1.0 - w, 0.0, w}, 5U};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {{0.0, 1.0 - w, w}, 6U};
  }
  const double scale = 1.0 / (va + vb + vc);
  const double v = vb * scale;
  const double w = vc * scale;
  return {{1.0 - v - w, v, w}, 7U};
}

ClosestOfEdges closestOfEdges(const Vec3& a0, const Vec3& a1, const Vec3& b0, const Vec3& b1) {
  const Vec3 u = a1 - a0;
  const Vec3 v = b1 - b0;
  const Vec3 w = a0 - b0;
  const double uu = u.squaredNorm();
  const double uv = u.dot(v);
  const double vv = v.squaredNorm();
  const double across = uu * vv - uv * uv;
  if (!(across > kParallel * uu * vv)) return {};
  const double uw = u.dot(w);
  const double vw = v.dot(w);
  return {(uv * vw - vv * uw) / across, (uu * vw - uv * uw) / across, false};
}

}  // namespace sim
