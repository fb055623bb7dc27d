#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "modeling/shapes/bezier.h"
#include "sim/base/result.h"

namespace modeling {

/// Value of a segment at t in [0, 1].
template <class Point>
Point evaluate(const CubicSegment<Point>& p, double t) {
  const double s = 1.0 - t;
  return s * s * s * p[0] + 3.0 * s * s * t * p[1] + 3.0 * s * t * t * p[2] + t * t * t * p[3];
}

/// Derivative of a segment with respect to t.
template <class Point>
Point derivative(const CubicSegment<Point>& p, double t) {
  const double s = 1.0 - t;
  return 3.0 * (s * s * (p[1] - p[0]) + 2.0 * s * t * (p[2] - p[1]) + t * t * (p[3] - p[2]));
}

/// What is wrong with a chain, if anything: no segment, a number that is not finite, no length, or a gap.
template <class Point>
std::optional<sim::Problem> checkChain(const CubicChain<Point>& chain, const std::string& place) {
  if (chain.empty())
    return sim::Problem{place, "the curve has no segment", "give at least one cubic segment"};
  double size = 0.0;
  for (const auto& segment : chain)
    for (const Point& point : segment) {
      if (!point.allFinite())
        return sim::Problem{place, "a control point is not finite", "give finite numbers"};
      size = std::max(size, (point - chain.front()[0]).norm());
    }
  if (!(size > 0.0)) return sim::Problem{place, "the curve has no length", "move its control points apart"};
  for (std::size_t i = 1; i < chain.size(); ++i)
    if ((chain[i][0] - chain[i - 1][3]).norm() > 1e-6 * size)
      return sim::Problem{place + "[" + std::to_string(i) + "]",
                          "the segment does not start where the one before it ends",
                          "make its first control point the last one of the segment before"};
  return std::nullopt;
}

/// A chain that can be walked by length. The table has kSamples steps a segment, which places points to about
/// 1e-5 of their spacing; points are always exactly on the curve.
template <class Point>
class MeasuredChain {
 public:
  /// A place on the chain by its segment and the segment's own parameter.
  struct Place {
    std::size_t segment = 0;
    double t = 0.0;
  };

  explicit MeasuredChain(CubicChain<Point> chain) : chain_(std::move(chain)) {
    lengths_.reserve(chain_.size() * kSamples + 1);
    lengths_.push_back(0.0);
    for (const auto& segment : chain_)
      for (std::size_t i = 0; i < kSamples; ++i)
        lengths_.push_back(lengths_.back() +
                           (evaluate(segment, step(i + 1)) - evaluate(segment, step(i))).norm());
  }

  const CubicChain<Point>& segments() const { return chain_; }
  double length() const { return lengths_.back(); }
  /// Length from the start to the end of a segment.
  double lengthTo(std::size_t segmentEnd) const { return lengths_[(segmentEnd + 1) * kSamples]; }

  Place atLength(double length) const {
    const auto above = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, length);
    const auto interval = static_cast<std::size_t>(above - lengths_.begin()) - 1;
    const double span = lengths_[interval + 1] - lengths_[interval];
    const double within = span > 0.0 ? std::clamp((length - lengths_[interval]) / span, 0.0, 1.0) : 0.0;
    return {interval / kSamples,
            (static_cast<double>(interval % kSamples) + within) / static_cast<double>(kSamples)};
  }
  Place atShare(double share) const { return atLength(share * length()); }

  Point point(const Place& place) const { return evaluate(chain_[place.segment], place.t); }
  /// Unit tangent; where the derivative vanishes (coincident control points), the chord nearby.
  Point tangent(const Place& place) const {
    const auto& segment = chain_[place.segment];
    const Point slope = derivative(segment, place.t);
    const double half = 0.5 / static_cast<double>(kSamples);
    if (slope.norm() > 1e-9 * length()) return slope.normalized();
    return (evaluate(segment, std::min(1.0, place.t + half)) -
            evaluate(segment, std::max(0.0, place.t - half)))
        .normalized();
  }

 private:
  static constexpr std::size_t kSamples = 256;
  static double step(std::size_t i) { return static_cast<double>(i) / static_cast<double>(kSamples); }

  CubicChain<Point> chain_;
  std::vector<double> lengths_;
};

}  // namespace modeling
