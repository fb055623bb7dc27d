#include "ui/editors/points_tool.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/kinds/bezier_edit.h"
#include "ui/theme/theme.h"

namespace ui {
namespace {

using modeling::Vec3;

constexpr double kGrabDistance = 11.0;  ///< logical pixels
constexpr double kDragDistance = 3.0;   ///< logical pixels: less is a click

QString tr(const char* text) {
  return QCoreApplication::translate("points tool", text);
}

double distance(const QPointF& a, const QPointF& b) {
  return std::hypot(a.x() - b.x(), a.y() - b.y());
}

/// The point of a line through `from` that is nearest to a line of sight.
Vec3 alongAxis(const Ray& ray, const Vec3& from, const Vec3& axis) {
  const double cosine = ray.direction.dot(axis);
  const double sine = 1.0 - cosine * cosine;
  if (sine < 1e-6) return from;
  const Vec3 between = ray.origin - from;
  return from + (between.dot(axis) - between.dot(ray.direction) * cosine) / sine * axis;
}

Vec3 inPlane(const Ray& ray, const Vec3& from, const Vec3& normal) {
  const double slope = ray.direction.dot(normal);
  if (std::abs(slope) < 1e-9) return from;
  return ray.origin + (from - ray.origin).dot(normal) / slope * ray.direction;
}

QColor axisColour(Eigen::Index axis) {
  const Colours& colours = Theme::instance().colours();
  return axis == 0 ? colours.axisX : axis == 1 ? colours.axisY : colours.axisZ;
}

}  // namespace

QString PointsTool::hint() const {
  const modeling::Part* part = find();
  const bool isCurve = part != nullptr && !curvesOf(part->shape).empty();
  if (isCurve && dragging_)
    return tr("X, Y, Z keep to an axis; Alt moves one handle or end by itself; Esc undoes");
  return isCurve ? tr("Drag points; Ctrl and a click on the curve adds one, Delete removes; Shift selects "
                      "more, A all; "
                      "Tab or Esc ends")
                 : tr("Drag points; X, Y, Z keep to an axis; Shift selects more, A all; Tab or Esc ends");
}

const modeling::Part* PointsTool::find() const {
  for (const modeling::Part& part : session_.document().scene().parts)
    if (part.name == part_ && hasPoints(part.shape)) return &part;
  return nullptr;
}

void PointsTool::follow() {
  const modeling::Part* part = find();
  if (part != nullptr && known_ == part->shape) return;
  if (dragging_) session_.document().endGesture();
  dragging_ = false;
  grabbed_.reset();
  axis_.reset();
  hovered_.reset();
  insertion_.reset();
  known_ = part != nullptr ? std::optional(part->shape) : std::nullopt;
  const std::size_t count = part != nullptr ? pointsOf(part->shape)->points.size() : 0;
  std::erase_if(selected_, [count](std::size_t point) { return point >= count; });
}

std::optional<std::size_t> PointsTool::pointAt(const Viewport& viewport, const QPointF& pixel) const {
  const modeling::Part* part = find();
  if (part == nullptr) return std::nullopt;
  const Eigen::Affine3d worldFromPart = part->worldFromPart.worldFromPart();
  const ShapePoints shown = *pointsOf(part->shape);
  std::optional<std::size_t> best;
  double nearest = kGrabDistance;
  for (std::size_t i = 0; i < shown.points.size(); ++i) {
    const auto there = viewport.project(worldFromPart * shown.points[i].at);
    if (!there) continue;
    // Where a point and its handle or a section's end share a place, the point wins.
    const double here = distance(*there, pixel) + (shown.points[i].kind == ShapePointKind::point ? 0.0 : 1.5);
    if (here >= nearest) continue;
    nearest = here;
    best = i;
  }
  return best;
}

bool PointsTool::press(Viewport& viewport, const PointerEvent& event) {
  follow();
  const modeling::Part* part = find();
  if (part == nullptr) return false;
  const bool adds = event.modifiers.testFlag(Qt::ShiftModifier);
  grabbed_ = pointAt(viewport, event.position);
  if (const auto place = insertionAt(viewport, event)) {
    grabbed_.reset();
    insertAt(*place);
    viewport.update();
    return true;
  }
  if (!grabbed_) {
    if (!adds) selected_.clear();
    viewport.update();
    return true;
  }
  if (adds && selected_.contains(*grabbed_)) {
    selected_.erase(*grabbed_);
  } else {
    if (!adds && !selected_.contains(*grabbed_)) selected_.clear();
    selected_.insert(*grabbed_);
  }
  pressed_ = event.position;
  dragging_ = false;
  shapeAtPress_ = part->shape;
  grabbedAt_ = part->worldFromPart.worldFromPart() * pointsOf(part->shape)->points[*grabbed_].at;
  viewport.update();
  return true;
}

Vec3 PointsTool::target(const Viewport& viewport, const QPointF& pixel) const {
  const Ray ray = viewport.camera().rayThrough(pixel, viewport.viewSize());
  if (axis_) return alongAxis(ray, grabbedAt_, Vec3::Unit(*axis_));
  return inPlane(ray, grabbedAt_, viewport.camera().forward());
}

void PointsTool::write(const Vec3& worldBy, bool free) {
  const modeling::Part* part = find();
  if (part == nullptr || selected_.empty()) return;
  const Vec3 by = part->worldFromPart.worldFromPart().linear().inverse() * worldBy;
  modeling::PartShape shape = shapeAtPress_;
  movePoints(shape, selected_, by, free);
  const auto index = static_cast<std::size_t>(part - session_.document().scene().parts.data());
  known_ = shape;
  session_.document().edit(
      selected_.size() > 1 ? tr("Move points") : tr("Move point"),
      [&](modeling::Scene& scene) { scene.parts[index].shape = shape; }, QStringLiteral("shape points"));
}

void PointsTool::move(Viewport& viewport, const PointerEvent& event) {
  follow();
  if (!grabbed_) return;
  if (!dragging_ && distance(event.position, pressed_) < kDragDistance) return;
  dragging_ = true;
  const Vec3 from = target(viewport, pressed_);
  Vec3 by = target(viewport, event.position) - from;
  // Where the pointer was a little beside the point at the press, it stays so; Ctrl rounds to millimetres.
  if (event.modifiers.testFlag(Qt::ControlModifier)) by = (by * 10.0).array().round().matrix() / 10.0;
  write(by, event.modifiers.testFlag(Qt::AltModifier));
  viewport.update();
}

void PointsTool::release(Viewport& viewport, const PointerEvent&) {
  follow();
  if (dragging_) session_.document().endGesture();
  dragging_ = false;
  grabbed_.reset();
  axis_.reset();
  viewport.update();
}

void PointsTool::hover(Viewport& viewport, const PointerEvent& event) {
  follow();
  const auto before = hovered_;
  const bool showed = insertion_.has_value();
  hovered_ = pointAt(viewport, event.position);
  insertion_.reset();
  if (const auto place = insertionAt(viewport, event)) {
    hovered_.reset();
    const modeling::Part& part = *find();
    const modeling::CurveChain& curve = *curvesOf(part.shape)[place->curve];
    insertion_ = part.worldFromPart.worldFromPart() * modeling::evaluate(curve[place->segment], place->t);
  }
  if (hovered_ != before || showed || insertion_) viewport.update();
}

/// With Ctrl the curve is meant, though handles lie near; only its points are where no other can be.
std::optional<CurvePoint> PointsTool::insertionAt(const Viewport& viewport, const PointerEvent& event) const {
  if (!event.modifiers.testFlag(Qt::ControlModifier)) return std::nullopt;
  if (const auto near = pointAt(viewport, event.position)) {
    if (pointsOf(find()->shape)->points[*near].kind == ShapePointKind::point) return std::nullopt;
  }
  return curveAt(viewport, event.position);
}

std::optional<CurvePoint> PointsTool::curveAt(const Viewport& viewport, const QPointF& pixel) const {
  const modeling::Part* part = find();
  if (part == nullptr) return std::nullopt;
  const Eigen::Affine3d worldFromPart = part->worldFromPart.worldFromPart();
  const auto distanceTo = [&](const Vec3& point) {
    const auto there = viewport.project(worldFromPart * point);
    return there ? distance(*there, pixel) : std::numeric_limits<double>::max();
  };
  std::optional<CurvePoint> best;
  double nearest = kGrabDistance;
  const std::vector<const modeling::CurveChain*> curves = curvesOf(part->shape);
  for (std::size_t curve = 0; curve < curves.size(); ++curve) {
    const NearestPlace place = nearestPlace(*curves[curve], distanceTo);
    if (place.distance >= nearest) continue;
    nearest = place.distance;
    best = CurvePoint{curve, place.segment, place.t};
  }
  return best;
}

void PointsTool::edit(const QString& name, const modeling::PartShape& shape) {
  const auto index = static_cast<std::size_t>(find() - session_.document().scene().parts.data());
  known_ = shape;
  session_.document().edit(name, [&](modeling::Scene& scene) { scene.parts[index].shape = shape; });
}

void PointsTool::insertAt(const CurvePoint& place) {
  modeling::PartShape shape = find()->shape;
  const std::size_t inserted = insertPoint(shape, place);
  edit(tr("Insert point"), shape);
  selected_ = {inserted};
  insertion_.reset();
}

void PointsTool::removeSelected() {
  const modeling::Part* part = find();
  if (part == nullptr) return;
  modeling::PartShape shape = part->shape;
  if (!removePoints(shape, selected_)) return;
  selected_.clear();
  hovered_.reset();
  edit(tr("Delete points"), shape);
}

bool PointsTool::cancel(Viewport& viewport) {
  follow();
  axis_.reset();
  if (!grabbed_) return false;
  if (dragging_) {
    write(Vec3::Zero(), true);
    session_.document().endGesture();
  }
  dragging_ = false;
  grabbed_.reset();
  viewport.update();
  return true;
}

void PointsTool::selectAll() {
  const modeling::Part* part = find();
  if (part == nullptr) return;
  std::set<std::size_t> all;
  const ShapePoints shown = *pointsOf(part->shape);
  for (std::size_t i = 0; i < shown.points.size(); ++i)
    if (shown.points[i].kind == ShapePointKind::point) all.insert(i);
  selected_ = selected_ == all ? std::set<std::size_t>{} : all;
}

bool PointsTool::takes(int key, Qt::KeyboardModifiers modifiers) {
  static constexpr std::array kKeys{Qt::Key_X, Qt::Key_Y, Qt::Key_Z, Qt::Key_A, Qt::Key_Delete};
  return modifiers == Qt::NoModifier && std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
}

bool PointsTool::key(Viewport& viewport, int key, Qt::KeyboardModifiers modifiers) {
  if (!takes(key, modifiers)) return false;
  follow();
  const Eigen::Index axis = key == Qt::Key_X ? 0 : key == Qt::Key_Y ? 1 : key == Qt::Key_Z ? 2 : -1;
  if (axis >= 0) {
    axis_ = axis_ == axis ? std::nullopt : std::optional(axis);
  } else if (key == Qt::Key_A) {
    selectAll();
  } else if (key == Qt::Key_Delete) {
    removeSelected();
  }
  viewport.update();
  return true;
}

void PointsTool::draw(const Viewport&, Overlay& overlay) {
  follow();
  const modeling::Part* part = find();
  if (part == nullptr) return;
  const Colours& colours = Theme::instance().colours();
  const Eigen::Affine3d worldFromPart = part->worldFromPart.worldFromPart();
  const ShapePoints shown = *pointsOf(part->shape);
  for (const ShapeLine& line : shown.lines)
    overlay.line(worldFromPart * line.from, worldFromPart * line.to,
                 line.isCurve ? colours.accent : colours.dimText, line.isCurve ? 2.0 : 1.2);
  if (axis_ && grabbed_) {
    constexpr double kReach = 1000.0;  // cm: out of the picture on both sides
    const Vec3 way = Vec3::Unit(*axis_) * kReach;
    overlay.line(grabbedAt_ - way, grabbedAt_ + way, axisColour(*axis_), 1.2);
  }
  if (insertion_) overlay.point(*insertion_, colours.good, 9.0);
  for (std::size_t i = 0; i < shown.points.size(); ++i) {
    const ShapePoint& point = shown.points[i];
    const Vec3 at = worldFromPart * point.at;
    const bool isPoint = point.kind == ShapePointKind::point;
    const double diameter = (isPoint ? 9.0 : 7.0) + (hovered_ == i ? 2.5 : 0.0);
    const QColor own = isPoint                                ? colours.accent
                       : point.kind == ShapePointKind::handle ? colours.dimText
                                                              : colours.good;
    overlay.point(at, colours.window, diameter + 3.0);
    overlay.point(at, selected_.contains(i) ? colours.warning : own, diameter);
  }
}

}  // namespace ui
