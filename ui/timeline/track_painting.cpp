#include "ui/timeline/track_painting.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

#include "ui/document/selection.h"
#include "ui/document/track_titles.h"
#include "ui/theme/theme.h"
#include "ui/timeline/time_axis.h"
#include "ui/timeline/time_painting.h"

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
  const sim::Vec3 value = modeling::asVector(valueAt(track, time));
  if (!track.target.isVector()) return numberText(value.x()) + unitText(unitOf(track.target));
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

void paintHeader(QPainter& painter, const TrackPicture& picture, std::size_t track) {
  const Colours& colours = Theme::instance().colours();
  const QRectF row = picture.layout.rowOf(track);
  const bool selected = picture.selection.contains({ItemKind::track, track});
  if (selected)
    painter.fillRect(QRectF(0, row.top(), kTimelineHeader, row.height()),
                     mixed(colours.panel, colours.accent, 0.25));
  const double middle = row.top() + 0.5 * TrackLayout::kRowHeight;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colours.dimText, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  const QPointF closed[] = {{12, middle - 4}, {16, middle}, {12, middle + 4}};
  const QPointF open[] = {{10, middle - 2}, {14, middle + 2}, {18, middle - 2}};
  painter.drawPolyline(picture.layout.isExpanded(track) ? open : closed, 3);
  painter.setRenderHint(QPainter::Antialiasing, false);

  const modeling::SceneTrack& found = picture.layout.tracks()[track];
  const QString value = valueText(found, picture.cursorTime);
  const QFont numbers = Theme::numberFont(-1.0);
  const bool below = found.target.isVector();
  const double valueWidth = QFontMetricsF(numbers).horizontalAdvance(value);
  const QRectF line(24, row.top(), kTimelineHeader - 34, TrackLayout::kRowHeight);
  painter.setPen(colours.text);
  painter.setFont(picture.font);
  const double room = below ? line.width() : line.width() - valueWidth - 8;
  painter.drawText(
      line, Qt::AlignVCenter,
      painter.fontMetrics().elidedText(titleOf(found.target), Qt::ElideRight, static_cast<int>(room)));
  if (below && !picture.layout.isExpanded(track)) return;
  painter.setPen(colours.dimText);
  painter.setFont(numbers);
  painter.drawText(below ? line.translated(0, 20) : line,
                   Qt::AlignVCenter | (below ? Qt::AlignLeft : Qt::AlignRight), value);
}

void paintScale(QPainter& painter, const TrackPicture& picture, std::size_t track) {
  if (!picture.layout.isExpanded(track)) return;
  const Colours& colours = Theme::instance().colours();
  const ValueSpan span = spanOf(picture.layout.tracks()[track]);
  painter.setFont(Theme::numberFont(-2.0));
  for (const double value : {span.least, span.most}) {
    const double y = picture.layout.yOf(track, value);
    horizontalLine(painter, kTimelineHeader, picture.size.width(), y,
                   mixed(colours.panel, colours.line, 0.7));
    painter.setPen(colours.dimText);
    painter.drawText(QRectF(picture.size.width() - 86, y - 13, 80, 12), Qt::AlignRight | Qt::AlignVCenter,
                     numberText(value));
  }
}

void paintCurve(QPainter& painter, const TrackPicture& picture, std::size_t track) {
  const TrackLayout& layout = picture.layout;
  const modeling::SceneTrack& found = layout.tracks()[track];
  const bool expanded = layout.isExpanded(track);
  const QRectF row = layout.rowOf(track);
  const ValueSpan span = spanOf(found);
  const auto y = [&](double value) {
    if (expanded) return layout.yOf(track, value);
    // Faint and flat in a narrow row: that something changes, and how.
    const double share = (value - span.least) / (span.most - span.least);
    return row.bottom() - 6.0 - share * (row.height() - 12.0);
  };
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  for (std::size_t c = 0; c < componentsOf(found.target); ++c) {
    std::vector<QPointF> points;
    for (const modeling::SceneTrackKey& key : found.keys)
      points.emplace_back(layout.xOf(key.time),
                          y(modeling::asVector(key.value)[static_cast<Eigen::Index>(c)]));
    QColor colour = colourOf(found, c);
    if (!expanded) colour.setAlphaF(0.55F);
    painter.setPen(QPen(colour, expanded ? 1.6 : 1.2));
    painter.drawPath(curveThrough(points, found.interpolation, picture.size.width()));
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void paintKeys(QPainter& painter, const TrackPicture& picture, std::size_t track) {
  const TrackLayout& layout = picture.layout;
  const Colours& colours = Theme::instance().colours();
  const modeling::SceneTrack& found = layout.tracks()[track];
  painter.setRenderHint(QPainter::Antialiasing);
  for (std::size_t key = 0; key < found.keys.size(); ++key) {
    const bool chosen = picture.chosen == KeyPlace{track, key};
    for (std::size_t c = 0; c < layout.handlesOf(track); ++c) {
      const QPointF at = layout.pointOf({{track, key}, c});
      const double radius = chosen ? 6.0 : 5.0;
      const QPointF corners[] = {at + QPointF(0, -radius), at + QPointF(radius, 0), at + QPointF(0, radius),
                                 at + QPointF(-radius, 0)};
      painter.setPen(QPen(colours.panel, 1.5));
      painter.setBrush(chosen                     ? colours.warning
                       : layout.isExpanded(track) ? colourOf(found, c)
                                                  : colours.text);
      painter.drawConvexPolygon(corners, 4);
    }
  }
  painter.setRenderHint(QPainter::Antialiasing, false);
}

}  // namespace

void paintTracks(QPainter& painter, const TrackPicture& picture, const QRect& dirty) {
  const TrackLayout& layout = picture.layout;
  const int width = picture.size.width();
  const int height = picture.size.height();
  const Colours& colours = Theme::instance().colours();
  painter.fillRect(dirty, colours.panel);
  if (layout.tracks().empty()) {
    painter.setPen(colours.dimText);
    painter.drawText(QRect(QPoint(), picture.size), Qt::AlignCenter,
                     QCoreApplication::translate(
                         "ui::TrackRows", "No tracks. Add one above, or perform something while it runs."));
    return;
  }
  const QRect timeArea(kTimelineHeader, 0, width - kTimelineHeader, height);
  for (std::size_t track = 0; track < layout.tracks().size(); ++track) {
    const QRectF row = layout.rowOf(track);
    if (!row.toAlignedRect().intersects(dirty)) continue;
    if (dirty.left() < kTimelineHeader) paintHeader(painter, picture, track);
    painter.save();
    painter.setClipRect(timeArea & dirty);
    painter.fillRect(QRectF(layout.xOf(0.0), row.top(),
                            layout.axis().xOf(layout.axis().end()) - layout.axis().xOf(0.0), row.height()),
                     mixed(colours.panel, colours.field, 0.55));
    paintScale(painter, picture, track);
    paintCurve(painter, picture, track);
    paintKeys(painter, picture, track);
    painter.restore();
    horizontalLine(painter, 0, width, row.bottom() - 0.5, colours.line);
  }
  painter.setClipRect(timeArea);
  verticalLine(painter, picture.cursorX, 0, height, colours.text, 1.5);
  painter.setClipping(false);
  verticalLine(painter, kTimelineHeader - 0.5, 0, height, colours.line);
}

}  // namespace ui
