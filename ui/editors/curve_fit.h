#pragma once

#include <vector>

#include "modeling/shapes/bezier.h"

namespace ui {

/// A point of a curve that is to be drawn by Beziers, and the unit direction in which the curve goes there.
struct CurveSample {
  modeling::Vec2 at = modeling::Vec2::Zero();
  modeling::Vec2 along = modeling::Vec2::UnitX();
};

struct CurveFit {
  modeling::CubicSegment<modeling::Vec2> segment;
  double worst = 0.0;           ///< cm, largest distance of a sample from the segment
  std::size_t worstSample = 0;  ///< which
};

/// The cubic that starts and ends as the samples from `begin` to `end` (both included, at least two) do, in
/// place and direction, and lies nearest to those between (P. J. Schneider, "An algorithm for automatically
/// fitting digitized curves", Graphics Gems, 1990).
CurveFit fitSegment(const std::vector<CurveSample>& samples, std::size_t begin, std::size_t end);

/// As few segments as keep within `tolerance` of the samples; the indices of the samples where they meet are
/// added to `breaks`.
modeling::ProfileChain fitChain(const std::vector<CurveSample>& samples, std::size_t begin, std::size_t end,
                                double tolerance, std::vector<std::size_t>& breaks);

}  // namespace ui
