#include "ui/editors/profile_model.h"

#include <algorithm>
#include <cmath>

#include "modeling/shapes/wall_profile.h"
#include "ui/editors/curve_fit.h"
#include "ui/editors/offset_profile.h"
#include "ui/kinds/bezier_edit.h"

namespace ui {
namespace {

using modeling::ProfileChain;
using modeling::Vec2;

constexpr double kSmoothAngle = 1e-3;  ///< rad: handles as near to one line as this count as on it
constexpr std::array kSides{ProfileSide::outside, ProfileSide::inside};

ProfileSide otherSide(ProfileSide side) {
  return side == ProfileSide::outside ? ProfileSide::inside : ProfileSide::outside;
}

/// The parameter at which a segment has gone a share of its length.
double atShare(const modeling::CubicSegment<Vec2>& segment, double share) {
  return modeling::MeasuredChain<Vec2>({segment}).atShare(share).t;
}

double shareAt(const modeling::CubicSegment<Vec2>& segment, double t) {
  const auto [before, after] = split(segment, t);
  const double first = modeling::MeasuredChain<Vec2>({before}).length();
  const double second = modeling::MeasuredChain<Vec2>({after}).length();
  return first + second > 0.0 ? first / (first + second) : t;
}

/// Samples of both segments, to put one in their place.
modeling::CubicSegment<Vec2> joined(const modeling::CubicSegment<Vec2>& before,
                                    const modeling::CubicSegment<Vec2>& after) {
  constexpr int kSamples = 24;
  const modeling::MeasuredChain<Vec2> chain({before, after});
  std::vector<CurveSample> samples;
  for (int i = 0; i <= 2 * kSamples; ++i) {
    const auto place = chain.atShare(i / (2.0 * kSamples));
    samples.push_back({chain.point(place), chain.tangent(place)});
  }
  return fitSegment(samples, 0, samples.size() - 1).segment;
}

}  // namespace

double ProfileModel::size() const {
  double size = 0.0;
  for (const ProfileSide side : kSides)
    for (const auto& segment : chain(side))
      for (const Vec2& point : segment) size = std::max(size, (point - shape_.outside.front()[0]).norm());
  return size;
}

Vec2 ProfileModel::position(const ControlId& control) const {
  const ProfileChain& segments = chain(control.side);
  if (control.index == 0) return segments.front()[0];
  return segments[(control.index - 1) / 3][(control.index - 1) % 3 + 1];
}

void ProfileModel::write(ProfileSide side, const Controls& controls) {
  (side == ProfileSide::outside ? shape_.outside : shape_.inside) = chainOf(controls);
}

bool ProfileModel::isEnd(const ControlId& control) const {
  return control.index == 0 || control.index + 1 == controlCount(control.side);
}

bool ProfileModel::isSmooth(const ControlId& point) const {
  if (!point.isPoint() || isEnd(point)) return false;
  const Vec2 at = position(point);
  const Vec2 before = at - position({point.side, point.index - 1});
  const Vec2 after = position({point.side, point.index + 1}) - at;
  if (!(before.norm() > 0.0) || !(after.norm() > 0.0)) return false;
  const double across = before.x() * after.y() - before.y() * after.x();
  return std::abs(std::atan2(across, before.dot(after))) < kSmoothAngle;
}

bool ProfileModel::isSolid() const {
  const Controls controls = controlsOf(shape_.inside);
  return std::all_of(controls.begin(), controls.end(), [&](const Vec2& point) { return onAxis(point); });
}

bool ProfileModel::isClosed(ProfileEnd end) const {
  return onAxis(end == ProfileEnd::start ? shape_.outside.front()[0] : shape_.outside.back()[3]);
}

double ProfileModel::meanThickness() const {
  const auto wall = modeling::WallProfile::make(shape_);
  return wall ? wall->meanThickness() : 0.0;
}

std::optional<sim::Problem> ProfileModel::problem() const {
  const auto wall = modeling::WallProfile::make(shape_);
  if (wall) return std::nullopt;
  return wall.problem();
}

ControlId ProfileModel::insert(ProfileSide side, std::size_t segment, double t) {
  const double share = shareAt(chain(side)[segment], t);
  splitAt(side == ProfileSide::outside ? shape_.outside : shape_.inside, segment, t);
  if (shape_.correspondence == modeling::ProfileCorrespondence::segments) {
    ProfileChain& other = side == ProfileSide::outside ? shape_.inside : shape_.outside;
    splitAt(other, segment, atShare(other[segment], share));
  }
  return {side, 3 * (segment + 1)};
}

void ProfileModel::removePoint(ProfileSide side, std::size_t point) {
  ProfileChain& segments = side == ProfileSide::outside ? shape_.outside : shape_.inside;
  segments[point - 1] = joined(segments[point - 1], segments[point]);
  for (Vec2& control : segments[point - 1]) control.x() = std::max(0.0, control.x());
  segments.erase(segments.begin() + static_cast<std::ptrdiff_t>(point));
}

sim::Status ProfileModel::remove(const ControlSet& controls) {
  const bool together = shape_.correspondence == modeling::ProfileCorrespondence::segments;
  std::set<std::pair<ProfileSide, std::size_t>> points;
  for (const ControlId& control : controls) {
    if (!control.isPoint() || isEnd(control)) continue;
    points.insert({control.side, control.index / 3});
    if (together) points.insert({otherSide(control.side), control.index / 3});
  }
  if (points.empty())
    return sim::Problem{"", "the ends of a profile and its handles cannot be deleted",
                        "select a point between the ends"};
  for (auto point = points.rbegin(); point != points.rend(); ++point)
    removePoint(point->first, point->second);
  return sim::Done{};
}

void ProfileModel::move(const ControlSet& controls, const Vec2& by, HandleRule rule) {
  const ProfileModel before = *this;
  ControlSet moved = controls;
  for (const ControlId& control : controls) {
    if (!control.isPoint()) continue;
    if (control.index > 0) moved.insert({control.side, control.index - 1});
    if (control.index + 1 < controlCount(control.side)) moved.insert({control.side, control.index + 1});
  }
  const bool solid = isSolid();
  for (const ProfileSide side : kSides) {
    Controls row = controlsOf(chain(side));
    for (const ControlId& control : moved) {
      if (control.side != side || control.index >= row.size()) continue;
      Vec2& at = row[control.index];
      at += by;
      at.x() = solid && side == ProfileSide::inside ? 0.0 : std::max(0.0, at.x());
    }
    if (rule == HandleRule::keepSmooth) turnPartners(before, moved, row, side);
    write(side, row);
  }
  keepEnds(before);
}

void ProfileModel::place(const ControlId& control, const Vec2& at, HandleRule rule) {
  move({control}, at - position(control), rule);
}

void ProfileModel::turnPartners(const ProfileModel& before, const ControlSet& moved, Controls& controls,
                                ProfileSide side) {
  for (const ControlId& control : moved) {
    if (control.side != side || control.isPoint()) continue;
    const ControlId point = control.point();
    const ControlId partner{side, 2 * point.index - control.index};
    if (!before.isSmooth(point) || moved.contains(point) || moved.contains(partner)) continue;
    const Vec2 handle = controls[control.index] - controls[point.index];
    const double length = (controls[partner.index] - controls[point.index]).norm();
    if (!(handle.norm() > 1e-9)) continue;
    Vec2 turned = controls[point.index] - length * handle.normalized();
    if (turned.x() < 0.0) {
      const double back = controls[point.index].x() - turned.x();
      turned = controls[point.index] + (controls[point.index].x() / back) * (turned - controls[point.index]);
      turned.x() = 0.0;
    }
    controls[partner.index] = turned;
  }
}

/// What was on the axis stays on it; what was a rim and touches the axis now closes, and the other profile
/// with it.
void ProfileModel::keepEnds(const ProfileModel& before) {
  if (before.isSolid()) return;
  for (const ProfileEnd end : {ProfileEnd::start, ProfileEnd::end}) {
    const auto indexOf = [&](ProfileSide side) {
      return end == ProfileEnd::start ? std::size_t{0} : controlCount(side) - 1;
    };
    const bool wasClosed = before.isClosed(end);
    bool touches = false;
    for (const ProfileSide side : kSides) touches |= onAxis(position({side, indexOf(side)}));
    if (!wasClosed && !touches) continue;
    for (const ProfileSide side : kSides) {
      Controls row = controlsOf(chain(side));
      row[indexOf(side)].x() = 0.0;
      write(side, row);
    }
    if (wasClosed) continue;
    // A rim whose two edges are level would leave no wall on the axis.
    Controls row = controlsOf(shape_.inside);
    const double outside = position({ProfileSide::outside, indexOf(ProfileSide::outside)}).y();
    Vec2& inside = row[indexOf(ProfileSide::inside)];
    const ControlId edge{ProfileSide::outside, indexOf(ProfileSide::outside)};
    const double width =
        (before.position(edge) - before.position({ProfileSide::inside, indexOf(ProfileSide::inside)})).norm();
    const double way = insideOf(before.shape().outside) * (end == ProfileEnd::start ? 1.0 : -1.0);
    if (way * (inside.y() - outside) < 0.5 * width) inside.y() = outside + way * width;
    write(ProfileSide::inside, row);
  }
}

void ProfileModel::makeSmooth(const ControlSet& controls) {
  for (const ControlId& control : controls) {
    const ControlId point = control.point();
    if (!has(point) || isEnd(point) || isSmooth(point)) continue;
    Controls row = controlsOf(chain(point.side));
    const std::size_t i = point.index;
    Vec2 before = row[i] - row[i - 1];
    Vec2 after = row[i + 1] - row[i];
    const double least = 1e-6 * size();
    // A handle that lies on its point has no direction, and one towards the neighbour will do.
    if (before.norm() < least) before = (row[i] - row[i - 3]) / 3.0;
    if (after.norm() < least) after = (row[i + 3] - row[i]) / 3.0;
    Vec2 way = before.normalized() + after.normalized();
    if (way.norm() < 1e-6) way = Vec2(-before.y(), before.x());
    way.normalize();
    const auto reach = [&](const Vec2& direction, double length) {
      return direction.x() < 0.0 ? std::min(length, row[i].x() / -direction.x()) : length;
    };
    row[i - 1] = row[i] - reach(Vec2(-way), before.norm()) * way;
    row[i + 1] = row[i] + reach(way, after.norm()) * way;
    if (isSolid() && point.side == ProfileSide::inside) row[i - 1].x() = row[i + 1].x() = 0.0;
    for (const std::size_t handle : {i - 1, i + 1}) row[handle].x() = std::max(0.0, row[handle].x());
    write(point.side, row);
  }
}

void ProfileModel::makeCorner(const ControlSet& controls) {
  for (const ControlId& control : controls) {
    const ControlId point = control.point();
    if (!has(point)) continue;
    Controls row = controlsOf(chain(point.side));
    const std::size_t i = point.index;
    if (i > 0) row[i - 1] = row[i] + (row[i - 3] - row[i]) / 3.0;
    if (i + 1 < row.size()) row[i + 1] = row[i] + (row[i + 3] - row[i]) / 3.0;
    write(point.side, row);
  }
}

void ProfileModel::straightenSegment(ProfileSide side, std::size_t segment) {
  auto& piece = (side == ProfileSide::outside ? shape_.outside : shape_.inside)[segment];
  piece = modeling::straightSegment(piece[0], piece[3]);
}

void ProfileModel::straighten(const ControlSet& controls) {
  ControlSet points;
  for (const ControlId& control : controls) points.insert(control.point());
  for (const ProfileSide side : kSides)
    for (std::size_t segment = 0; segment < chain(side).size(); ++segment) {
      const bool first = points.contains({side, 3 * segment});
      const bool last = points.contains({side, 3 * segment + 3});
      if ((first && last) || (points.size() == 1 && (first || last))) straightenSegment(side, segment);
    }
}

void ProfileModel::close(ProfileEnd end) {
  if (isSolid() || isClosed(end)) return;
  ControlSet ends;
  double farthest = 0.0;
  for (const ProfileSide side : kSides) {
    const ControlId id{side, end == ProfileEnd::start ? 0 : controlCount(side) - 1};
    ends.insert(id);
    farthest = std::max(farthest, position(id).x());
  }
  move(ends, Vec2(-farthest, 0.0));
}

void ProfileModel::open(ProfileEnd end) {
  if (isSolid() || !isClosed(end)) return;
  constexpr double kShare = 0.3;  ///< of the way to the next point, so that most of the base stays
  for (const ProfileSide side : kSides) {
    Controls row = controlsOf(chain(side));
    if (end == ProfileEnd::end) std::reverse(row.begin(), row.end());
    const double reach = std::max(row[3].x(), kLeastRim / kShare);
    for (std::size_t i = 0; i < 3; ++i) row[i].x() = kShare * reach + (1.0 - kShare) * row[i].x();
    if (end == ProfileEnd::end) std::reverse(row.begin(), row.end());
    write(side, row);
  }
}

sim::Status ProfileModel::offsetInside(double thickness) {
  auto wall = ui::offsetInside(shape_.outside, thickness);
  if (!wall) return wall.problem();
  shape_.outside = std::move(wall->outside);
  shape_.inside = std::move(wall->inside);
  shape_.correspondence = wall->correspondence;
  return sim::Done{};
}

}  // namespace ui
