#include "ui/viewport/transform_gizmo.h"

#include <QPolygonF>
#include <cmath>
#include <limits>
#include <numbers>

#include "ui/theme/theme.h"

namespace ui {
namespace {

constexpr double kLength = 84.0;  ///< logical pixels, of an arrow or the radius of a ring
constexpr double kReach = 8.0;    ///< logical pixels: how far off a handle may be hit
constexpr double kSquareFrom = 0.30;
constexpr double kSquareTo = 0.48;
constexpr int kRingSteps = 64;
constexpr double kTurn = 2.0 * std::numbers::pi;

double distanceToSegment(const QPointF& point, const QPointF& from, const QPointF& to) {
  const QPointF along = to - from;
  const double squared = QPointF::dotProduct(along, along);
  const double share =
      squared > 0.0 ? std::clamp(QPointF::dotProduct(point - from, along) / squared, 0.0, 1.0) : 0.0;
  const QPointF away = point - from - share * along;
  return std::hypot(away.x(), away.y());
}

bool isLit(const std::optional<TransformHold>& lit, TransformHold::Kind kind, int axis) {
  return lit && lit->kind == kind && (kind == TransformHold::Kind::free || lit->axis == axis);
}

}  // namespace

QColor TransformGizmo::colourOf(int axis) {
  const Colours& colours = Theme::instance().colours();
  return axis == 0 ? colours.axisX : axis == 1 ? colours.axisY : colours.axisZ;
}

double TransformGizmo::length(const ViewCamera& camera, const QSizeF& size) const {
  return kLength * camera.pixelSize(pivot_, size);
}

std::array<sim::Vec3, 4> TransformGizmo::square(int axis, double length) const {
  const sim::Vec3 u = length * direction((axis + 1) % 3);
  const sim::Vec3 v = length * direction((axis + 2) % 3);
  return {pivot_ + kSquareFrom * u + kSquareFrom * v, pivot_ + kSquareTo * u + kSquareFrom * v,
          pivot_ + kSquareTo * u + kSquareTo * v, pivot_ + kSquareFrom * u + kSquareTo * v};
}

sim::Vec3 TransformGizmo::onRing(int axis, double angle, double radius) const {
  return pivot_ +
         radius * (std::cos(angle) * direction((axis + 1) % 3) + std::sin(angle) * direction((axis + 2) % 3));
}

double TransformGizmo::distanceToAxis(int axis, const QPointF& pixel, const ViewCamera& camera,
                                      const QSizeF& size) const {
  const double reach = length(camera, size);
  const auto from = camera.project(pivot_ + 0.18 * reach * direction(axis), size);
  const auto to = camera.project(pivot_ + 1.06 * reach * direction(axis), size);
  return from && to ? distanceToSegment(pixel, *from, *to) : std::numeric_limits<double>::infinity();
}

double TransformGizmo::distanceToRing(int axis, const QPointF& pixel, const ViewCamera& camera,
                                      const QSizeF& size) const {
  const double radius = length(camera, size);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kRingSteps; ++i) {
    const auto from = camera.project(onRing(axis, kTurn * i / kRingSteps, radius), size);
    const auto to = camera.project(onRing(axis, kTurn * (i + 1) / kRingSteps, radius), size);
    if (from && to) least = std::min(least, distanceToSegment(pixel, *from, *to));
  }
  return least;
}

bool TransformGizmo::isInSquare(int axis, const QPointF& pixel, const ViewCamera& camera,
                                const QSizeF& size) const {
  QPolygonF polygon;
  for (const sim::Vec3& corner : square(axis, length(camera, size))) {
    if (const auto place = camera.project(corner, size)) polygon << *place;
  }
  return polygon.size() == 4 && polygon.containsPoint(pixel, Qt::OddEvenFill);
}

std::optional<TransformHold> TransformGizmo::at(const QPointF& pixel, const ViewCamera& camera,
                                                const QSizeF& size) const {
  using Kind = TransformHold::Kind;
  const auto middle = camera.project(pivot_, size);
  if (!middle) return std::nullopt;
  const QPointF away = pixel - *middle;
  const double fromMiddle = std::hypot(away.x(), away.y());
  if (mode_ == TransformMode::rotate) {
    if (std::abs(fromMiddle - 1.18 * kLength) < 5.0) return TransformHold{Kind::free, 0};
  } else {
    if (fromMiddle < 11.0) return TransformHold{Kind::free, 0};
    for (int axis = 0; axis < 3; ++axis) {
      if (isInSquare(axis, pixel, camera, size)) return TransformHold{Kind::plane, axis};
    }
  }
  std::optional<TransformHold> nearest;
  double least = kReach;
  for (int axis = 0; axis < 3; ++axis) {
    const double distance = mode_ == TransformMode::rotate ? distanceToRing(axis, pixel, camera, size)
                                                           : distanceToAxis(axis, pixel, camera, size);
    if (distance >= least) continue;
    least = distance;
    nearest = TransformHold{Kind::axis, axis};
  }
  return nearest;
}

void TransformGizmo::drawMoveOrScale(double length, const std::optional<TransformHold>& lit,
                                     Overlay& overlay) const {
  using Kind = TransformHold::Kind;
  const QColor bright = Theme::instance().colours().text;
  for (int axis = 0; axis < 3; ++axis) {
    const bool axisLit = isLit(lit, Kind::axis, axis);
    const QColor colour = axisLit ? bright : colourOf(axis);
    const sim::Vec3 end = pivot_ + length * direction(axis);
    overlay.line(pivot_ + 0.16 * length * direction(axis), end, colour, axisLit ? 3.5 : 2.5);
    if (mode_ == TransformMode::scale) {
      overlay.point(end, colour, 11.0);
    } else {
      // An arrowhead as a thick bar that gets thinner: the overlay knows lines only.
      for (int i = 0; i < 6; ++i) {
        const double share = i / 6.0;
        overlay.line(end + 0.16 * length * share * direction(axis),
                     end + 0.16 * length * (share + 0.17) * direction(axis), colour,
                     9.0 * (1.0 - share) + 1.0);
      }
    }
    const bool planeLit = isLit(lit, Kind::plane, axis);
    QColor edge = planeLit ? bright : colourOf(axis);
    if (!planeLit) edge.setAlphaF(0.8F);
    const std::array<sim::Vec3, 4> corners = square(axis, length);
    for (std::size_t c = 0; c < 4; ++c)
      overlay.line(corners[c], corners[(c + 1) % 4], edge, planeLit ? 3.0 : 1.8);
  }
  overlay.point(pivot_, isLit(lit, Kind::free, 0) ? bright : Theme::instance().colours().accent, 13.0);
}

void TransformGizmo::drawRotate(const ViewCamera& camera, double length,
                                const std::optional<TransformHold>& lit, Overlay& overlay) const {
  using Kind = TransformHold::Kind;
  const Colours& colours = Theme::instance().colours();
  for (int axis = 0; axis < 3; ++axis) {
    const bool ringLit = isLit(lit, Kind::axis, axis);
    for (int i = 0; i < kRingSteps; ++i) {
      const sim::Vec3 from = onRing(axis, kTurn * i / kRingSteps, length);
      QColor colour = ringLit ? colours.text : colourOf(axis);
      // The far half stands back.
      if ((from - pivot_).dot(camera.forward()) > 0.05 * length) colour.setAlphaF(0.25F);
      overlay.line(from, onRing(axis, kTurn * (i + 1) / kRingSteps, length), colour, ringLit ? 3.5 : 2.3);
    }
  }
  const QColor outer = isLit(lit, Kind::free, 0) ? colours.text : colours.dimText;
  for (int i = 0; i < kRingSteps; ++i) {
    const auto at = [&](int step) -> sim::Vec3 {
      const double angle = kTurn * step / kRingSteps;
      return pivot_ + 1.18 * length * (std::cos(angle) * camera.right() + std::sin(angle) * camera.up());
    };
    overlay.line(at(i), at(i + 1), outer, 1.6);
  }
}

void TransformGizmo::draw(const ViewCamera& camera, const QSizeF& size,
                          const std::optional<TransformHold>& lit, Overlay& overlay) const {
  if (mode_ == TransformMode::rotate) {
    drawRotate(camera, length(camera, size), lit, overlay);
  } else {
    drawMoveOrScale(length(camera, size), lit, overlay);
  }
}

}  // namespace ui
