#include "ui/editors/offset_profile.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "ui/editors/curve_fit.h"
#include "ui/kinds/bezier_edit.h"

namespace ui {
namespace {

using modeling::ProfileChain;
using modeling::Vec2;

constexpr int kSamples = 96;             ///< a segment
constexpr double kFitTolerance = 1e-2;   ///< of the thickness
constexpr double kKeepTolerance = 3e-3;  ///< of the thickness: nearer to the outside than this is a loop
constexpr double kCornerAngle = 2e-3;    ///< rad, between the two directions of a point that is no corner
constexpr double kMiterAngle = 0.2;  ///< rad: a corner that turns less stays one, half a percent too far out
constexpr double kArcStep = 0.05;    ///< rad, between samples around a corner

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}
Vec2 leftOf(const Vec2& way) {
  return {-way.y(), way.x()};
}
Vec2 turned(const Vec2& way, double angle) {
  return Eigen::Rotation2D<double>(angle) * way;
}

/// A point of the raw offset curve, and where on the outside it belongs: segment + t.
struct OffsetSample {
  CurveSample curve;
  double place = 0.0;
  std::size_t index = 0;  ///< of the raw curve
  bool corner = false;    ///< the next is in the same place, where the curve has another direction
};

/// Where pieces of the inside that are fitted by themselves meet.
struct Joint {
  std::size_t sample = 0;  ///< of the kept ones; the first of the two where directions differ
  double place = 0.0;
  bool corner = false;  ///< the curve goes on with the next sample, which is in the same place
};

class Offsetter {
 public:
  Offsetter(const ProfileChain& outside, double thickness)
      : outside_(outside), thickness_(thickness), side_(insideOf(outside)) {
    for (const auto& segment : outside_)
      for (const Vec2& point : segment) size_ = std::max(size_, (point - outside_.front()[0]).norm());
  }

  sim::Result<OffsetWall> run() {
    sampleOutside();
    trim();
    const bool rimsKept = (onAxis(outside_.front()[0]) || isKept(raw_.front().curve.at)) &&
                          (onAxis(outside_.back()[3]) || isKept(raw_.back().curve.at));
    const auto pinched = [&](const Joint& joint) { return onAxis(kept_[joint.sample].curve.at); };
    if (kept_.size() < 4 || !rimsKept || std::any_of(joints_.begin(), joints_.end(), pinched))
      return sim::Problem{"", "a wall as thick as this leaves no room inside", "use a smaller thickness"};
    addKnotJoints();
    return fitted();
  }

 private:
  bool onAxis(const Vec2& point) const { return point.x() <= 1e-6 * size_; }
  Vec2 waySafe(std::size_t segment, double t) const {
    const Vec2 slope = modeling::derivative(outside_[segment], t);
    if (slope.norm() > 1e-7 * size_) return slope.normalized();
    const double from = std::max(0.0, t - 1e-3);
    const double to = std::min(1.0, t + 1e-3);
    const Vec2 chord =
        modeling::evaluate(outside_[segment], to) - modeling::evaluate(outside_[segment], from);
    return chord.norm() > 0.0 ? Vec2(chord.normalized()) : Vec2(Vec2::UnitX());
  }
  void add(const Vec2& from, const Vec2& way, double place) {
    raw_.push_back({{from + side_ * thickness_ * leftOf(way), way}, place});
  }

  void sampleOutside() {
    startAtAxis();
    for (std::size_t segment = 0; segment < outside_.size(); ++segment) {
      for (int i = 0; i <= kSamples; ++i) {
        const double t = static_cast<double>(i) / kSamples;
        const Vec2 at = modeling::evaluate(outside_[segment], t);
        line_.push_back(at);
        if (i == 0 && segment > 0) {
          roundCorner(at, waySafe(segment - 1, 1.0), waySafe(segment, 0.0), static_cast<double>(segment));
          continue;
        }
        add(at, waySafe(segment, t), static_cast<double>(segment) + t);
      }
    }
    endAtAxis();
  }

  /// Around a corner that turns away from the inside, an arc; at any other, what overlaps is trimmed later.
  void roundCorner(const Vec2& corner, const Vec2& before, const Vec2& after, double place) {
    const double angle = std::atan2(cross(before, after), before.dot(after));
    if (std::abs(angle) < kCornerAngle) return;
    if (side_ * angle < 0.0 && -side_ * angle < kMiterAngle) {
      const Vec2 middle = turned(before, 0.5 * angle);
      const Vec2 at = corner + side_ * thickness_ / std::cos(0.5 * angle) * leftOf(middle);
      raw_.push_back({{at, before}, place, 0, true});
      raw_.push_back({{at, after}, place});
    } else if (side_ * angle < 0.0) {
      const int steps = std::max(2, static_cast<int>(std::ceil(std::abs(angle) / kArcStep)));
      for (int i = 1; i < steps; ++i) add(corner, turned(before, angle * i / steps), place);
    }
    add(corner, after, place);
  }

  /// A profile that reaches the axis at a slant is mirrored there into a corner; the inside goes on around it
  /// until it is on the axis as well, where it is level.
  void startAtAxis() {
    const Vec2 at = outside_.front()[0];
    if (onAxis(at)) roundCorner(at, Vec2::UnitX(), waySafe(0, 0.0), 0.0);
    if (onAxis(at) && !raw_.empty()) {
      raw_.pop_back();  // which the first sample of the profile is
      raw_.insert(raw_.begin(), {{at + side_ * thickness_ * Vec2::UnitY(), Vec2::UnitX()}, 0.0});
    }
  }
  void endAtAxis() {
    const Vec2 at = outside_.back()[3];
    const auto place = static_cast<double>(outside_.size());
    if (onAxis(at)) roundCorner(at, waySafe(outside_.size() - 1, 1.0), -Vec2::UnitX(), place);
  }

  double distanceToOutside(const Vec2& point) const {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < line_.size(); ++i) {
      const Vec2 way = line_[i] - line_[i - 1];
      const double share =
          std::clamp(way.dot(point - line_[i - 1]) / std::max(way.squaredNorm(), 1e-300), 0.0, 1.0);
      best = std::min(best, (line_[i - 1] + share * way - point).squaredNorm());
    }
    return std::sqrt(best);
  }
  bool isKept(const Vec2& point) const {
    return point.x() >= -1e-9 * size_ && distanceToOutside(point) >= thickness_ * (1.0 - kKeepTolerance);
  }

  void trim() {
    for (std::size_t i = 0; i < raw_.size(); ++i) raw_[i].index = i;
    std::optional<std::size_t> last;
    for (std::size_t i = 0; i < raw_.size(); ++i) {
      if (!isKept(raw_[i].curve.at)) continue;
      if (!last && i > 0) meetAxis(i, i - 1);
      if (last && i > *last + 1) {
        i = bridge(*last, i);
      } else {
        if (raw_[i].corner) joints_.push_back({kept_.size(), raw_[i].place, true});
        kept_.push_back(raw_[i]);
      }
      last = i;
    }
    if (last && *last + 1 < raw_.size()) meetAxis(*last, *last + 1);
    for (OffsetSample& sample : kept_) sample.curve.at.x() = std::max(0.0, sample.curve.at.x());
  }

  /// The curve left the half-plane between two samples: one on the axis takes the place of what is beyond.
  void meetAxis(std::size_t inner, std::size_t beyond) {
    const bool meets = onAxis(beyond < inner ? outside_.front()[0] : outside_.back()[3]);
    if (!meets) return;
    OffsetSample sample = raw_[inner];
    const Vec2 way = raw_[beyond].curve.at - sample.curve.at;
    const double share = way.x() < 0.0 ? sample.curve.at.x() / -way.x() : 0.0;
    sample.curve.at += std::min(share, 1.0) * way;
    sample.curve.at.x() = 0.0;
    sample.place = beyond < inner ? 0.0 : static_cast<double>(outside_.size());
    kept_.push_back(sample);
  }

  /// A loop between two kept samples goes: the curve has a corner where the two branches cross. Answers the
  /// first sample after it.
  std::size_t bridge(std::size_t before, std::size_t after) {
    // A few samples beyond the crossing may have been kept, as near as they are to it.
    constexpr std::size_t kBeyond = 6;
    std::size_t from = before - std::min({before, kBeyond, kept_.size() - 1});
    std::size_t to = std::min(after + kBeyond, raw_.size() - 1);
    const Vec2 at = crossing(from, to, before, after);
    while (kept_.size() > 1 && kept_.back().index > from) kept_.pop_back();
    OffsetSample one = raw_[from];
    OffsetSample two = raw_[to];
    one.curve.at = two.curve.at = at;
    one.place = two.place = placeBetween(one.place, two.place);
    joints_.push_back({kept_.size(), one.place, true});
    kept_.push_back(one);
    kept_.push_back(two);
    return to;
  }

  /// Where the curve between two samples crosses itself; they become the two that are nearest to it, outside
  /// of the loop. Where it does not, half-way between the given ends.
  Vec2 crossing(std::size_t& from, std::size_t& to, std::size_t before, std::size_t after) const {
    for (std::size_t i = from; i <= before; ++i)
      for (std::size_t j = to; j-- > std::max(after - 1, i + 2);) {
        const Vec2& a = raw_[i].curve.at;
        const Vec2& c = raw_[j].curve.at;
        const Vec2 ab = raw_[i + 1].curve.at - a;
        const Vec2 cd = raw_[j + 1].curve.at - c;
        const double scale = cross(ab, cd);
        if (std::abs(scale) < 1e-18) continue;
        const double along = cross(c - a, cd) / scale;
        const double across = cross(c - a, ab) / scale;
        if (along < 0.0 || along > 1.0 || across < 0.0 || across > 1.0) continue;
        from = i;
        to = j + 1;
        return a + along * ab;
      }
    from = before;
    to = after;
    return 0.5 * (raw_[before].curve.at + raw_[after].curve.at);
  }

  /// What a corner of the inside corresponds to on the outside: the point there, if there is one.
  static double placeBetween(double from, double to) {
    const double knot = std::ceil(from);
    return knot <= to ? knot : 0.5 * (from + to);
  }

  /// The points of the outside that the inside has as well.
  void addKnotJoints() {
    for (std::size_t knot = 1; knot < outside_.size(); ++knot) {
      const auto place = static_cast<double>(knot);
      const auto isHere = [&](const auto& item) { return item.place == place; };
      if (std::any_of(joints_.begin(), joints_.end(), isHere)) continue;
      const auto first = std::find_if(kept_.begin(), kept_.end(), isHere);
      if (first == kept_.end()) continue;
      const auto last = std::find_if_not(first, kept_.end(), isHere);
      const auto sample = (first - kept_.begin() + (last - 1 - kept_.begin())) / 2;
      if (sample > 0 && sample + 1 < static_cast<std::ptrdiff_t>(kept_.size()))
        joints_.push_back({static_cast<std::size_t>(sample), place, false});
    }
    std::sort(joints_.begin(), joints_.end(),
              [](const Joint& a, const Joint& b) { return a.sample < b.sample; });
  }

  OffsetWall fitted() {
    std::vector<CurveSample> curve;
    for (const OffsetSample& sample : kept_) curve.push_back(sample.curve);
    OffsetWall wall;
    std::vector<double> places;
    std::size_t begin = 0;
    joints_.push_back({curve.size() - 1, static_cast<double>(outside_.size()), false});
    for (const Joint& joint : joints_) {
      if (joint.sample == begin && joint.sample + 1 < curve.size()) continue;
      std::vector<std::size_t> breaks;
      for (auto segment : fitChain(curve, begin, joint.sample, kFitTolerance * thickness_, breaks)) {
        for (Vec2& point : segment) point.x() = std::max(0.0, point.x());
        wall.inside.push_back(segment);
      }
      for (const std::size_t index : breaks) places.push_back(kept_[index].place);
      places.push_back(joint.place);
      begin = joint.sample + (joint.corner ? 1 : 0);
    }
    wall.outside = outside_;
    match(places, wall);
    return wall;
  }

  /// Gives the outside the inside's points, where each point of it has its own.
  void match(const std::vector<double>& places, OffsetWall& wall) const {
    ProfileChain divided;
    double from = 0.0;
    bool matches = true;
    for (const double to : places) {
      const double segment = std::ceil(to) - 1.0;
      const double start = from - segment;
      const double end = to - segment;
      matches = matches && start >= 0.0 && end - start > 1e-3;
      if (!matches) break;
      auto piece = split(outside_[static_cast<std::size_t>(segment)], end).first;
      if (start > 0.0) piece = split(piece, start / end).second;
      divided.push_back(piece);
      from = to;
    }
    if (matches) wall.outside = std::move(divided);
    wall.correspondence =
        matches ? modeling::ProfileCorrespondence::segments : modeling::ProfileCorrespondence::arcLength;
  }

  const ProfileChain& outside_;
  const double thickness_;
  const double side_;
  double size_ = 0.0;
  std::vector<Vec2> line_;  ///< the outside, as points close together
  std::vector<OffsetSample> raw_;
  std::vector<OffsetSample> kept_;
  std::vector<Joint> joints_;
};

}  // namespace

double insideOf(const ProfileChain& outside) {
  double area = 0.0;  // between the axis and the profile, as it goes upwards
  for (const auto& segment : outside) {
    Vec2 before = segment[0];
    for (int i = 1; i <= 32; ++i) {
      const Vec2 here = modeling::evaluate(segment, i / 32.0);
      area += 0.5 * (before.x() + here.x()) * (here.y() - before.y());
      before = here;
    }
  }
  return area < 0.0 ? -1.0 : 1.0;
}

sim::Result<OffsetWall> offsetInside(const ProfileChain& outside, double thickness) {
  if (auto problem = modeling::checkChain(outside, "outside")) return *problem;
  if (!(thickness > 0.0) || !std::isfinite(thickness))
    return sim::Problem{"thickness", "a wall must be thicker than 0 cm", "give a thickness"};
  return Offsetter(outside, thickness).run();
}

}  // namespace ui
