#pragma once

#include <set>
#include <vector>

#include "modeling/shapes/revolution.h"
#include "sim/base/result.h"

namespace ui {

enum class ProfileSide { outside, inside };
enum class ProfileEnd { start, end };

/// One control point of a profile, counted along it: every third is a point of the curve, those between are
/// handles.
struct ControlId {
  ProfileSide side = ProfileSide::outside;
  std::size_t index = 0;

  bool isPoint() const { return index % 3 == 0; }
  /// The point of the curve that a handle belongs to; a point is its own.
  ControlId point() const { return {side, (index + 1) / 3 * 3}; }
  auto operator<=>(const ControlId&) const = default;
};
using ControlSet = std::set<ControlId>;

enum class HandleRule {
  keepSmooth,  ///< the other handle of a smooth point turns along
  free,
};

/// The two profiles of a solid of revolution, and what can be done to them. Keeps to what RevolutionShape
/// asks for: r is never below 0; an end is a rim or on the axis for both profiles together; profiles that
/// correspond by segments get and lose points together. That they cross nowhere it cannot promise.
class ProfileModel {
 public:
  /// A rim stays at least this far from the axis, cm, unless it is closed.
  static constexpr double kLeastRim = 0.05;

  explicit ProfileModel(modeling::RevolutionShape shape) : shape_(std::move(shape)) {}

  const modeling::RevolutionShape& shape() const { return shape_; }
  const modeling::ProfileChain& chain(ProfileSide side) const {
    return side == ProfileSide::outside ? shape_.outside : shape_.inside;
  }
  std::size_t controlCount(ProfileSide side) const { return 3 * chain(side).size() + 1; }
  bool has(const ControlId& control) const { return control.index < controlCount(control.side); }
  modeling::Vec2 position(const ControlId& control) const;
  bool isEnd(const ControlId& control) const;
  /// Both handles of a point lie on one line through it.
  bool isSmooth(const ControlId& point) const;
  /// The inside lies on the axis from end to end.
  bool isSolid() const;
  /// The wall closes over the axis there.
  bool isClosed(ProfileEnd end) const;
  /// Mean distance of points that face each other, cm.
  double meanThickness() const;
  /// What is wrong with the wall, in words, if anything is: what build() would say.
  std::optional<sim::Problem> problem() const;

  /// A point on the curve, which stays as it is. Answers the new point.
  ControlId insert(ProfileSide side, std::size_t segment, double t);
  /// Takes points out; what is left keeps to the curve as near as it can. Ends stay where they are.
  sim::Status remove(const ControlSet& controls);
  /// Points take their handles along. A rim that is moved onto the axis closes.
  void move(const ControlSet& controls, const modeling::Vec2& by, HandleRule rule = HandleRule::keepSmooth);
  void place(const ControlId& control, const modeling::Vec2& at, HandleRule rule = HandleRule::keepSmooth);
  void makeSmooth(const ControlSet& controls);
  /// Handles point at the neighbours.
  void makeCorner(const ControlSet& controls);
  /// The segments both of whose ends are among the controls; a single point: those on both sides of it.
  void straighten(const ControlSet& controls);
  void straightenSegment(ProfileSide side, std::size_t segment);
  /// Lets both profiles end on the axis there, or both in a rim.
  void close(ProfileEnd end);
  void open(ProfileEnd end);
  /// The inside anew, one thickness from the outside, which may get points but stays where it is.
  sim::Status offsetInside(double thickness);

 private:
  using Controls = std::vector<modeling::Vec2>;
  void write(ProfileSide side, const Controls& controls);
  double size() const;
  bool onAxis(const modeling::Vec2& point) const { return point.x() <= 1e-6 * size(); }
  void removePoint(ProfileSide side, std::size_t point);
  void turnPartners(const ProfileModel& before, const ControlSet& moved, Controls& controls,
                    ProfileSide side);
  void keepEnds(const ProfileModel& before);

  modeling::RevolutionShape shape_;
};

}  // namespace ui
