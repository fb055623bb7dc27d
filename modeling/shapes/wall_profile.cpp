#include "modeling/shapes/wall_profile.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace modeling {
namespace {

// Fine enough to find a bend to 1/2048 of the profile, which is well below a cell.
constexpr std::size_t kSpineSamples = 2048;

double shareOf(std::size_t sample) {
  return static_cast<double>(sample) / static_cast<double>(kSpineSamples);
}

std::string describe(const Vec2& point) {
  char text[64];
  std::snprintf(text, sizeof text, "r = %.4g, z = %.4g", point.x(), point.y());
  return text;
}

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

sim::Result<WallProfile> WallProfile::make(const RevolutionShape& shape) {
  if (auto problem = checkChain(shape.outside, "outside")) return *problem;
  if (auto problem = checkChain(shape.inside, "inside")) return *problem;
  if (shape.correspondence == ProfileCorrespondence::segments && shape.outside.size() != shape.inside.size())
    return sim::Problem{"correspondence", "the profiles have different numbers of segments",
                        "let them correspond by arc length, or give both the same number of segments"};
  WallProfile profile(shape);
  if (auto problem = profile.findEnds()) return *problem;
  profile.measureSpine();
  if (auto problem = profile.checkWall()) return *problem;
  return profile;
}

WallProfile::WallProfile(const RevolutionShape& shape)
    : outside_(shape.outside),
      inside_(shape.inside),
      bySegments_(shape.correspondence == ProfileCorrespondence::segments) {
  for (const auto* chain : {&shape.outside, &shape.inside})
    for (const auto& segment : *chain)
      for (const Vec2& point : segment) size_ = std::max(size_, (point - shape.outside.front()[0]).norm());
}

Vec2 WallProfile::at(const MeasuredChain<Vec2>& chain, double share) const {
  if (!bySegments_) return chain.point(chain.atShare(share));
  const auto count = static_cast<double>(chain.segments().size());
  const double segment = std::min(std::floor(share * count), count - 1.0);
  const auto index = static_cast<std::size_t>(segment);
  const double before = index > 0 ? chain.lengthTo(index - 1) : 0.0;
  return chain.point(chain.atLength(before + (share * count - segment) * (chain.lengthTo(index) - before)));
}

WallProfile::Pair WallProfile::pairAtShare(double share) const {
  return {at(outside_, share), at(inside_, share)};
}

WallProfile::Pair WallProfile::pairAt(double along) const {
  const auto above = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, along);
  const auto sample = static_cast<std::size_t>(above - lengths_.begin()) - 1;
  const double span = lengths_[sample + 1] - lengths_[sample];
  const double within = span > 0.0 ? std::clamp((along - lengths_[sample]) / span, 0.0, 1.0) : 0.0;
  return pairAtShare((static_cast<double>(sample) + within) / static_cast<double>(kSpineSamples));
}

std::optional<sim::Problem> WallProfile::findEnds() {
  solid_ = true;
  for (std::size_t i = 0; i <= kSpineSamples; ++i) {
    const Pair pair = pairAtShare(shareOf(i));
    for (const Vec2& point : {pair.outside, pair.inside})
      if (point.x() < -1e-6 * size_)
        return sim::Problem{"", "a profile crosses the axis at " + describe(point), "keep r at 0 or more"};
    solid_ = solid_ && onAxis(pair.inside);
  }
  for (const double share : {0.0, 1.0}) {
    const Pair pair = pairAtShare(share);
    const bool closed = onAxis(pair.outside);
    (share == 0.0 ? startClosed_ : endClosed_) = closed;
    if (solid_ || closed == onAxis(pair.inside)) continue;
    return sim::Problem{
        "", std::string("at the ") + (share == 0.0 ? "start" : "end") + " only one profile meets the axis",
        "end both profiles on the axis, or both off it"};
  }
  return std::nullopt;
}

void WallProfile::measureSpine() {
  lengths_.assign(1, 0.0);
  std::vector<Vec2> points;
  for (std::size_t i = 0; i <= kSpineSamples; ++i) {
    const Pair pair = pairAtShare(shareOf(i));
    points.push_back(spine(pair));
    largestRadius_ = std::max(largestRadius_, points[i].x());
    meanThickness_ += (pair.outside - pair.inside).norm() / static_cast<double>(kSpineSamples + 1);
    if (i > 0) lengths_.push_back(lengths_[i - 1] + (points[i] - points[i - 1]).norm());
  }
  // The way the spine leaves the axis, taken over a short stretch: a first control point may coincide with
  // the next.
  constexpr std::size_t kStretch = 8;
  const double turned = std::cos(std::numbers::pi / 4.0);
  const auto bend = [&](auto sample) {
    const Vec2 away = (points[sample(kStretch)] - points[sample(0)]).normalized();
    for (std::size_t i = kStretch; i < kSpineSamples; ++i) {
      const Vec2 here = (points[sample(i + 1)] - points[sample(i)]).normalized();
      if (here.dot(away) < turned) return std::abs(lengths_[sample(i)] - lengths_[sample(0)]);
    }
    return length();
  };
  startBend_ = bend([](std::size_t i) { return i; });
  endBend_ = bend([](std::size_t i) { return kSpineSamples - i; });
}

std::optional<sim::Problem> WallProfile::checkWall() const {
  double side = 0.0;
  for (std::size_t i = 0; i <= kSpineSamples; ++i) {
    const Pair pair = pairAtShare(shareOf(i));
    const bool solidEnd = solid_ && ((i == 0 && startClosed_) || (i == kSpineSamples && endClosed_));
    const Vec2 wall = pair.outside - pair.inside;
    if (!solidEnd && (solid_ ? onAxis(pair.outside) : wall.norm() <= 1e-6 * size_))
      return sim::Problem{"", "the profiles touch at " + describe(pair.outside), "leave a wall between them"};
    if (i == 0 || solid_) continue;
    const Pair before = pairAtShare(shareOf(i - 1));
    const double now = cross(spine(pair) - spine(before), wall);
    if (side * now < 0.0)
      return sim::Problem{"", "the profiles cross at " + describe(pair.outside),
                          "keep them apart, and let both run the same way"};
    if (now != 0.0) side = now;
  }
  return std::nullopt;
}

}  // namespace modeling
