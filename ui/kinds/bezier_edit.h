#pragma once

#include <algorithm>
#include <limits>
#include <utility>

#include "modeling/shapes/measured_chain.h"

/// What editors do to Bezier curves, in the plane or in space.
namespace ui {

/// The two parts of a segment before and after t, which together are the same curve (de Casteljau).
template <class Point>
std::pair<modeling::CubicSegment<Point>, modeling::CubicSegment<Point>> split(
    const modeling::CubicSegment<Point>& p, double t) {
  const auto between = [t](const Point& a, const Point& b) { return Point((1.0 - t) * a + t * b); };
  const Point first = between(p[0], p[1]);
  const Point middle = between(p[1], p[2]);
  const Point last = between(p[2], p[3]);
  const Point before = between(first, middle);
  const Point after = between(middle, last);
  const Point at = between(before, after);
  return {{p[0], first, before, at}, {at, after, last, p[3]}};
}

/// Cuts a segment of a chain in two; the curve stays as it is.
template <class Point>
void splitAt(modeling::CubicChain<Point>& chain, std::size_t segment, double t) {
  const auto [before, after] = split(chain[segment], t);
  chain[segment] = before;
  chain.insert(chain.begin() + static_cast<std::ptrdiff_t>(segment) + 1, after);
}

/// A place on a chain, and how far it is from what it was looked for.
struct NearestPlace {
  std::size_t segment = 0;
  double t = 0.0;
  double distance = std::numeric_limits<double>::infinity();
};

/// The place of a segment where `distanceTo(point)` is least: coarse samples first, then halving about the
/// best.
template <class Point, class Distance>
NearestPlace nearestInSegment(const modeling::CubicSegment<Point>& points, const Distance& distanceTo) {
  constexpr int kSamples = 48;
  NearestPlace best;
  const auto look = [&](double t) {
    const double distance = distanceTo(modeling::evaluate(points, t));
    if (distance < best.distance) best = {0, t, distance};
  };
  for (int i = 0; i <= kSamples; ++i) look(static_cast<double>(i) / kSamples);
  for (double step = 0.5 / kSamples; step > 1e-9; step *= 0.5) {
    const double middle = best.t;
    look(std::max(0.0, middle - step));
    look(std::min(1.0, middle + step));
  }
  return best;
}

/// Likewise of a chain.
template <class Point, class Distance>
NearestPlace nearestPlace(const modeling::CubicChain<Point>& chain, const Distance& distanceTo) {
  NearestPlace best;
  for (std::size_t segment = 0; segment < chain.size(); ++segment) {
    const NearestPlace here = nearestInSegment(chain[segment], distanceTo);
    if (here.distance < best.distance) best = {segment, here.t, here.distance};
  }
  return best;
}

/// Control points of a chain in a row, those that segments share once: 3 n + 1 of them, every third of which
/// the curve passes through.
template <class Point>
std::vector<Point> controlsOf(const modeling::CubicChain<Point>& chain) {
  std::vector<Point> controls;
  for (const auto& segment : chain) {
    if (controls.empty()) controls.push_back(segment[0]);
    controls.insert(controls.end(), segment.begin() + 1, segment.end());
  }
  return controls;
}

/// The other way round.
template <class Point>
modeling::CubicChain<Point> chainOf(const std::vector<Point>& controls) {
  modeling::CubicChain<Point> chain;
  for (std::size_t i = 0; i + 3 < controls.size(); i += 3)
    chain.push_back({controls[i], controls[i + 1], controls[i + 2], controls[i + 3]});
  return chain;
}

}  // namespace ui
