#include <algorithm>
#include <cmath>

#include "modeling/shapes/sweep_path.h"
#include "ui/kinds/bezier_edit.h"
#include "ui/kinds/point_handles.h"

namespace ui {
namespace {

using modeling::CurveChain;
using modeling::CurvedCylinderShape;
using modeling::PartShape;
using modeling::ValueChain;
using modeling::Vec3;

constexpr double kLeastSize = 0.02;         ///< cm, half of the thinnest section
constexpr double kSmoothCosine = -0.99999;  ///< of the angle between the two handles of a smooth point

std::size_t pointsOnCurve(const CurvedCylinderShape& shape) {
  return 3 * shape.curve.size() + 1;
}

std::size_t pointsOnRail(const CurvedCylinderShape& shape) {
  return shape.secondRail.empty() ? 0 : 3 * shape.secondRail.size() + 1;
}

/// Where a size of the section is held, and what it is there.
struct SizeHandle {
  ShapePointKind kind = ShapePointKind::width;
  std::size_t knot = 0;  ///< of the value's chain
  Vec3 centre, axis;
  double value = 0.0;
};

std::vector<double> knotShares(const CurvedCylinderShape& shape, std::size_t segments) {
  if (segments != shape.curve.size() || segments == 1) return {0.0, 1.0};
  const modeling::MeasuredChain<Vec3> curve(shape.curve);
  std::vector<double> shares{0.0};
  for (std::size_t i = 0; i < segments; ++i) shares.push_back(curve.lengthTo(i) / curve.length());
  return shares;
}

double valueAt(const ValueChain& values, std::size_t knot) {
  return knot == 0 ? values.front()[0] : values[knot - 1][3];
}

std::vector<SizeHandle> sizeHandles(const CurvedCylinderShape& shape) {
  constexpr int kStations = 96;
  std::vector<SizeHandle> handles;
  const auto path = modeling::SweepPath::make(shape);
  if (!path) return handles;
  const auto stations = path->stations(kStations);
  if (!stations) return handles;
  const auto add = [&](ShapePointKind kind, const ValueChain& values) {
    const std::vector<double> shares = knotShares(shape, values.size());
    for (std::size_t knot = 0; knot < shares.size(); ++knot) {
      const auto& station = (*stations)[static_cast<std::size_t>(std::lround(shares[knot] * kStations))];
      const Vec3& axis = kind == ShapePointKind::width ? station.first : station.second;
      handles.push_back({kind, knot, station.centre, axis, valueAt(values, knot)});
    }
  };
  if (shape.secondRail.empty()) add(ShapePointKind::width, shape.halfWidth);
  add(ShapePointKind::depth, shape.halfDepth);
  return handles;
}

void addCurve(const CurveChain& curve, ShapePoints& shown) {
  constexpr int kSteps = 24;
  const std::vector<Vec3> controls = controlsOf(curve);
  const std::size_t first = shown.points.size();
  for (std::size_t i = 0; i < controls.size(); ++i) {
    const std::size_t owner = (i + 1) / 3 * 3;
    shown.points.push_back(
        {i % 3 == 0 ? ShapePointKind::point : ShapePointKind::handle, controls[i], first + owner});
    if (i % 3 != 0) shown.lines.push_back({controls[owner], controls[i]});
  }
  for (const auto& segment : curve)
    for (int i = 0; i < kSteps; ++i)
      shown.lines.push_back({modeling::evaluate(segment, static_cast<double>(i) / kSteps),
                             modeling::evaluate(segment, (i + 1.0) / kSteps), true});
}

ShapePoints shownOf(const CurvedCylinderShape& shape) {
  ShapePoints shown;
  addCurve(shape.curve, shown);
  if (!shape.secondRail.empty()) addCurve(shape.secondRail, shown);
  for (const SizeHandle& handle : sizeHandles(shape)) {
    const Vec3 at = handle.centre + handle.value * handle.axis;
    shown.points.push_back({handle.kind, at, shown.points.size()});
    shown.lines.push_back({handle.centre, at});
  }
  return shown;
}

bool isSmooth(const std::vector<Vec3>& controls, std::size_t point) {
  if (point == 0 || point + 1 >= controls.size()) return false;
  const Vec3 before = controls[point - 1] - controls[point];
  const Vec3 after = controls[point + 1] - controls[point];
  return before.norm() > 0.0 && after.norm() > 0.0 &&
         before.normalized().dot(after.normalized()) < kSmoothCosine;
}

void moveCurve(CurveChain& curve, const std::set<std::size_t>& wanted, const Vec3& by, bool free) {
  const std::vector<Vec3> before = controlsOf(curve);
  std::set<std::size_t> moved = wanted;
  for (const std::size_t control : wanted) {
    if (control % 3 != 0) continue;
    if (control > 0) moved.insert(control - 1);
    if (control + 1 < before.size()) moved.insert(control + 1);
  }
  std::vector<Vec3> after = before;
  for (const std::size_t control : moved) after[control] += by;
  for (const std::size_t control : moved) {
    if (free || control % 3 == 0) continue;
    const std::size_t point = (control + 1) / 3 * 3;
    const std::size_t partner = 2 * point - control;
    if (!isSmooth(before, point) || moved.contains(point) || moved.contains(partner)) continue;
    const Vec3 handle = after[control] - after[point];
    if (handle.norm() > 1e-9)
      after[partner] = after[point] - (before[partner] - before[point]).norm() * handle.normalized();
  }
  curve = chainOf(after);
}

bool isConstant(const ValueChain& values) {
  for (const auto& segment : values)
    for (const double value : segment)
      if (value != values.front()[0]) return false;
  return true;
}

void changeSize(ValueChain& values, std::size_t knot, double by, bool free) {
  const auto grow = [&](double& value) { value = std::max(kLeastSize, value + by); };
  if (!free && isConstant(values)) {
    for (auto& segment : values)
      for (double& value : segment) grow(value);
    return;
  }
  if (knot > 0) {
    grow(values[knot - 1][3]);
    grow(values[knot - 1][2]);
  }
  if (knot < values.size()) {
    grow(values[knot][0]);
    grow(values[knot][1]);
  }
}

void moveIn(CurvedCylinderShape& shape, const std::set<std::size_t>& points, const Vec3& by, bool free) {
  const std::size_t onCurve = pointsOnCurve(shape);
  const std::size_t onRail = pointsOnRail(shape);
  std::set<std::size_t> ofCurve;
  std::set<std::size_t> ofRail;
  const std::vector<SizeHandle> sizes = sizeHandles(shape);
  for (const std::size_t point : points) {
    if (point < onCurve) {
      ofCurve.insert(point);
    } else if (point < onCurve + onRail) {
      ofRail.insert(point - onCurve);
    } else if (point - onCurve - onRail < sizes.size()) {
      const SizeHandle& handle = sizes[point - onCurve - onRail];
      ValueChain& values = handle.kind == ShapePointKind::width ? shape.halfWidth : shape.halfDepth;
      changeSize(values, handle.knot, by.dot(handle.axis), free);
    }
  }
  moveCurve(shape.curve, ofCurve, by, free);
  if (onRail > 0) moveCurve(shape.secondRail, ofRail, by, free);
}

/// Takes the points that the curve passes through at these knots; two stay.
template <class Point>
void removeKnots(modeling::CubicChain<Point>& chain, const std::set<std::size_t>& knots) {
  std::vector<Point> controls = controlsOf(chain);
  for (auto knot = knots.rbegin(); knot != knots.rend() && controls.size() > 4; ++knot) {
    const std::size_t last = controls.size() - 1;
    const std::size_t first = *knot == 0 ? 0 : 3 * *knot == last ? last - 2 : 3 * *knot - 1;
    const auto from = controls.begin() + static_cast<std::ptrdiff_t>(first);
    controls.erase(from, from + 3);
  }
  chain = chainOf(controls);
}

/// Chains that go along with the curve segment by segment.
template <class Change>
void changeSizes(CurvedCylinderShape& shape, const Change& change) {
  const std::size_t segments = shape.curve.size();
  for (ValueChain* values : {&shape.halfWidth, &shape.halfDepth})
    if (segments > 1 && values->size() == segments) change(*values);
}

std::size_t insertIn(CurvedCylinderShape& shape, const CurvePoint& place) {
  const bool onRail = place.curve == 1;
  if (!onRail) changeSizes(shape, [&](ValueChain& values) { splitAt(values, place.segment, place.t); });
  const std::size_t first = onRail ? pointsOnCurve(shape) : 0;
  splitAt(onRail ? shape.secondRail : shape.curve, place.segment, place.t);
  return first + 3 * (place.segment + 1);
}

bool removeIn(CurvedCylinderShape& shape, const std::set<std::size_t>& points) {
  const std::size_t onCurve = pointsOnCurve(shape);
  const std::size_t onRail = pointsOnRail(shape);
  std::set<std::size_t> ofCurve;
  std::set<std::size_t> ofRail;
  for (const std::size_t point : points) {
    if (point < onCurve && point % 3 == 0) ofCurve.insert(point / 3);
    if (point >= onCurve && point < onCurve + onRail && (point - onCurve) % 3 == 0)
      ofRail.insert((point - onCurve) / 3);
  }
  const CurvedCylinderShape before = shape;
  changeSizes(shape, [&](ValueChain& values) { removeKnots(values, ofCurve); });
  removeKnots(shape.curve, ofCurve);
  if (onRail > 0) removeKnots(shape.secondRail, ofRail);
  return shape != before;
}

/// The points of the centre line or first rail come first, then those of the second rail, then the sizes.
class SweepPoints : public PointHandles {
 public:
  ShapePoints shown(const PartShape& shape) const override { return shownOf(sweep(shape)); }
  void move(PartShape& shape, const std::set<std::size_t>& points, const Vec3& by, bool free) const override {
    moveIn(std::get<CurvedCylinderShape>(shape), points, by, free);
  }
  std::vector<const CurveChain*> curves(const PartShape& shape) const override {
    return {&sweep(shape).curve, &sweep(shape).secondRail};
  }
  std::size_t insert(PartShape& shape, const CurvePoint& place) const override {
    return insertIn(std::get<CurvedCylinderShape>(shape), place);
  }
  bool remove(PartShape& shape, const std::set<std::size_t>& points) const override {
    return removeIn(std::get<CurvedCylinderShape>(shape), points);
  }

 private:
  static const CurvedCylinderShape& sweep(const PartShape& shape) {
    return std::get<CurvedCylinderShape>(shape);
  }
};

}  // namespace

const PointHandles& sweepPoints() {
  static const SweepPoints points;
  return points;
}

}  // namespace ui
