#include <QPaintEvent>
#include <QPainter>
#include <QPainterPath>

#include "ui/session/session.h"
#include "ui/theme/theme.h"
#include "ui/timeline/time_axis.h"
#include "ui/timeline/time_bar.h"
#include "ui/timeline/time_painting.h"
#include "ui/timeline/track_rows.h"

namespace ui {
namespace {

QColor colourOf(const modeling::SceneTrack& track, std::size_t component) {
  const Colours& colours = Theme::instance().colours();
  if (!track.target.isVector()) return colours.accent;
  return component == 0 ? colours.axisX : component == 1 ? colours.axisY : colours.axisZ;
}

QString numberText(double value) {
  return QString::number(value, 'g', 4);
}

QString valueText(const modeling::SceneTrack& track, double time) {
  const sim::Vec3 value = asVector(valueAt(track, time));
  if (!track.target.isVector()) return numberText(value.x()) + unitOf(track.target);
  return QStringLiteral("%1  %2  %3")
      .arg(numberText(value.x()), numberText(value.y()), numberText(value.z()));
}

/// Level before the first and after the last.
QPainterPath curveThrough(const std::vector<QPointF>& points, sim::Interpolation interpolation,
                          double right) {
  QPainterPath path(QPointF(std::min(0.0, points.front().x()), points.front().y()));
  path.lineTo(points.front());
  for (std::size_t i = 1; i < points.size(); ++i) {
    const QPointF& from = points[i - 1];
    const QPointF& to = points[i];
    if (interpolation == sim::Interpolation::step) path.lineTo(to.x(), from.y());
    if (interpolation == sim::Interpolation::smooth) {
      // The easing 3t^2 - 2t^3, as the Bezier curve it is.
      const double third = (to.x() - from.x()) / 3.0;
      path.cubicTo(from + QPointF(third, 0.0), to - QPointF(third, 0.0), to);
    } else {
      path.lineTo(to);
    }
  }
  path.lineTo(std::max(right, points.back().x()), points.back().y());
  return path;
}

}  // namespace

void TrackRows::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  const Colours& colours = Theme::instance().colours();
  painter.fillRect(event->rect(), colours.panel);
  if (tracks().empty()) {
    painter.setPen(colours.dimText);
    painter.drawText(rect(), Qt::AlignCenter,
                     tr("No tracks. Add one above, or perform something while it runs."));
    return;
  }
  const QRect timeArea(kTimelineHeader, 0, width() - kTimelineHeader, height());
  for (std::size_t track = 0; track < tracks().size(); ++track) {
    const QRectF row = rowOf(track);
    if (!row.toAlignedRect().intersects(event->rect())) continue;
    if (event->rect().left() < kTimelineHeader) paintHeader(painter, track);
    painter.save();
    painter.setClipRect(timeArea & event->rect());
    painter.fillRect(QRectF(bar_.xOf(0.0), row.top(), axis_.xOf(axis_.end()) - axis_.xOf(0.0), row.height()),
                     mixed(colours.panel, colours.field, 0.55));
    paintScale(painter, track);
    paintCurve(painter, track);
    paintKeys(painter, track);
    painter.restore();
    horizontalLine(painter, 0, width(), row.bottom() - 0.5, colours.line);
  }
  painter.setClipRect(timeArea);
  verticalLine(painter, shownCursor_, 0, height(), colours.text, 1.5);
  painter.setClipping(false);
  verticalLine(painter, kTimelineHeader - 0.5, 0, height(), colours.line);
}

void TrackRows::paintHeader(QPainter& painter, std::size_t track) {
  const Colours& colours = Theme::instance().colours();
  const QRectF row = rowOf(track);
  const bool selected = session_.selection().contains({ItemKind::track, track});
  if (selected)
    painter.fillRect(QRectF(0, row.top(), kTimelineHeader, row.height()),
                     mixed(colours.panel, colours.accent, 0.25));
  const double middle = row.top() + 0.5 * kRowHeight;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colours.dimText, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  const QPointF closed[] = {{12, middle - 4}, {16, middle}, {12, middle + 4}};
  const QPointF open[] = {{10, middle - 2}, {14, middle + 2}, {18, middle - 2}};
  painter.drawPolyline(isExpanded(track) ? open : closed, 3);
  painter.setRenderHint(QPainter::Antialiasing, false);

  const modeling::SceneTrack& found = tracks()[track];
  const QString value = valueText(found, bar_.cursorTime());
  const QFont numbers = Theme::numberFont(-1.0);
  const bool below = found.target.isVector();
  const double valueWidth = QFontMetricsF(numbers).horizontalAdvance(value);
  const QRectF line(24, row.top(), kTimelineHeader - 34, kRowHeight);
  painter.setPen(colours.text);
  painter.setFont(font());
  const double room = below ? line.width() : line.width() - valueWidth - 8;
  painter.drawText(
      line, Qt::AlignVCenter,
      painter.fontMetrics().elidedText(titleOf(found.target), Qt::ElideRight, static_cast<int>(room)));
  if (below && !isExpanded(track)) return;
  painter.setPen(colours.dimText);
  painter.setFont(numbers);
  painter.drawText(below ? line.translated(0, 20) : line,
                   Qt::AlignVCenter | (below ? Qt::AlignLeft : Qt::AlignRight), value);
}

void TrackRows::paintScale(QPainter& painter, std::size_t track) {
  if (!isExpanded(track)) return;
  const Colours& colours = Theme::instance().colours();
  const Span span = spanOf(tracks()[track]);
  painter.setFont(Theme::numberFont(-2.0));
  for (const double value : {span.least, span.most}) {
    const double y = yOf(track, value);
    horizontalLine(painter, kTimelineHeader, width(), y, mixed(colours.panel, colours.line, 0.7));
    painter.setPen(colours.dimText);
    painter.drawText(QRectF(width() - 86, y - 13, 80, 12), Qt::AlignRight | Qt::AlignVCenter,
                     numberText(value));
  }
}

void TrackRows::paintCurve(QPainter& painter, std::size_t track) {
  const modeling::SceneTrack& found = tracks()[track];
  const bool expanded = isExpanded(track);
  const QRectF row = rowOf(track);
  const Span span = spanOf(found);
  const auto y = [&](double value) {
    if (expanded) return yOf(track, value);
    // Faint and flat in a narrow row: that something changes, and how.
    const double share = (value - span.least) / (span.most - span.least);
    return row.bottom() - 6.0 - share * (row.height() - 12.0);
  };
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  for (std::size_t c = 0; c < componentsOf(found.target); ++c) {
    std::vector<QPointF> points;
    for (const modeling::SceneTrackKey& key : found.keys)
      points.emplace_back(bar_.xOf(key.time), y(asVector(key.value)[static_cast<Eigen::Index>(c)]));
    QColor colour = colourOf(found, c);
    if (!expanded) colour.setAlphaF(0.55F);
    painter.setPen(QPen(colour, expanded ? 1.6 : 1.2));
    painter.drawPath(curveThrough(points, found.interpolation, width()));
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void TrackRows::paintKeys(QPainter& painter, std::size_t track) {
  const Colours& colours = Theme::instance().colours();
  const modeling::SceneTrack& found = tracks()[track];
  painter.setRenderHint(QPainter::Antialiasing);
  const std::size_t components = isExpanded(track) ? componentsOf(found.target) : 1;
  for (std::size_t key = 0; key < found.keys.size(); ++key) {
    const bool chosen = selected_ == KeyPlace{track, key};
    for (std::size_t c = 0; c < components; ++c) {
      const QPointF at = pointOf({track, key}, c);
      const double radius = chosen ? 6.0 : 5.0;
      const QPointF corners[] = {at + QPointF(0, -radius), at + QPointF(radius, 0), at + QPointF(0, radius),
                                 at + QPointF(-radius, 0)};
      painter.setPen(QPen(colours.panel, 1.5));
      painter.setBrush(chosen ? colours.warning : isExpanded(track) ? colourOf(found, c) : colours.text);
      painter.drawConvexPolygon(corners, 4);
    }
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
}

}  // namespace ui
