#include "ui/viewport/axis_gizmo.h"

#include <QPainter>
#include <algorithm>
#include <array>

#include "ui/theme/theme.h"

namespace ui {
namespace {

constexpr double kRadius = 42.0;  ///< logical pixels, of the whole
constexpr double kLength = 30.0;
constexpr double kBall = 8.5;
constexpr double kMargin = 14.0;

struct End {
  ViewCamera::Axis axis;
  sim::Vec3 direction;
  QChar name;
  bool positive;
};

const std::array<End, 6>& ends() {
  using Axis = ViewCamera::Axis;
  static const std::array<End, 6> kEnds{{{Axis::right, sim::Vec3::UnitX(), 'X', true},
                                         {Axis::left, -sim::Vec3::UnitX(), 'X', false},
                                         {Axis::back, sim::Vec3::UnitY(), 'Y', true},
                                         {Axis::front, -sim::Vec3::UnitY(), 'Y', false},
                                         {Axis::top, sim::Vec3::UnitZ(), 'Z', true},
                                         {Axis::bottom, -sim::Vec3::UnitZ(), 'Z', false}}};
  return kEnds;
}

QPointF placeOf(const End& end, const ViewCamera& camera) {
  return {kLength * end.direction.dot(camera.right()), -kLength * end.direction.dot(camera.up())};
}

QColor colourOf(const End& end) {
  const Colours& colours = Theme::instance().colours();
  if (end.name == 'X') return colours.axisX;
  return end.name == 'Y' ? colours.axisY : colours.axisZ;
}

/// The farthest first.
std::array<const End*, 6> byDepth(const ViewCamera& camera) {
  std::array<const End*, 6> order{};
  std::transform(ends().begin(), ends().end(), order.begin(), [](const End& end) { return &end; });
  std::sort(order.begin(), order.end(), [&](const End* a, const End* b) {
    return a->direction.dot(camera.forward()) > b->direction.dot(camera.forward());
  });
  return order;
}

}  // namespace

QPointF AxisGizmo::middle(const QSizeF& size) {
  return {kMargin + kRadius, size.height() - kMargin - kRadius};
}

bool AxisGizmo::contains(const QPointF& at, const QSizeF& size) const {
  const QPointF away = at - middle(size);
  return QPointF::dotProduct(away, away) <= kRadius * kRadius;
}

std::optional<ViewCamera::Axis> AxisGizmo::axisAt(const QPointF& at, const ViewCamera& camera,
                                                  const QSizeF& size) const {
  std::optional<ViewCamera::Axis> found;
  for (const End* end : byDepth(camera)) {
    const QPointF away = at - middle(size) - placeOf(*end, camera);
    if (QPointF::dotProduct(away, away) <= kBall * kBall) found = end->axis;
  }
  return found;
}

void AxisGizmo::paint(QPainter& painter, const ViewCamera& camera, const QSizeF& size,
                      const std::optional<QPointF>& pointer) const {
  const Colours& colours = Theme::instance().colours();
  painter.save();
  painter.translate(middle(size));
  if (pointer && contains(*pointer, size)) {
    QColor halo = colours.text;
    halo.setAlphaF(0.08F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(halo);
    painter.drawEllipse(QPointF(), kRadius, kRadius);
  }
  QFont font = painter.font();
  font.setPointSizeF(7.5);
  font.setBold(true);
  painter.setFont(font);
  const std::optional<ViewCamera::Axis> under = axisAt(pointer.value_or(QPointF(-1e6, 0.0)), camera, size);
  for (const End* end : byDepth(camera)) {
    QColor colour = colourOf(*end);
    const bool isUnder = under.has_value() && *under == end->axis;
    const QPointF place = placeOf(*end, camera);
    const bool away = end->direction.dot(camera.forward()) > 0.0;
    if (away) colour.setAlphaF(0.6F);
    if (end->positive) {
      painter.setPen(QPen(colour, 2.0, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(QPointF(), place);
    }
    painter.setPen(QPen(isUnder ? colours.text : colour, 1.5));
    QColor fill = colour;
    if (!end->positive)
      fill = QColor::fromRgbF(colours.viewBottom.redF(), colours.viewBottom.greenF(),
                              colours.viewBottom.blueF(), 0.55F);
    painter.setBrush(fill);
    painter.drawEllipse(place, kBall, kBall);
    if (!end->positive && !isUnder) continue;
    painter.setPen(end->positive ? colours.accentText : colours.text);
    painter.drawText(QRectF(place - QPointF(kBall, kBall), QSizeF(2 * kBall, 2 * kBall)), Qt::AlignCenter,
                     end->positive ? QString(end->name) : QStringLiteral("-") + end->name);
  }
  painter.restore();
}

}  // namespace ui
