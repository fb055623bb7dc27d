#include "ui/timeline/time_bar_painting.h"

#include <QCoreApplication>
#include <QPainter>
#include <cmath>

#include "ui/theme/theme.h"
#include "ui/timeline/time_axis.h"
#include "ui/timeline/time_bar.h"
#include "ui/timeline/time_painting.h"

namespace ui {
namespace {

constexpr double kFilmTop = TimeBar::kRulerHeight + 2.0;
constexpr double kFilmBottom = TimeBar::kRulerHeight + TimeBar::kFilmHeight;
constexpr double kLabelDistance = 72.0;

QString words(const char* text) {
  return QCoreApplication::translate("ui::TimeBar", text);
}

void paintHeader(QPainter& painter, const TimeBarPicture& picture) {
  const Colours& colours = Theme::instance().colours();
  const QRectF upper(10, 8, kTimelineHeader - 20, 18);
  painter.setPen(colours.text);
  QFont strong = picture.font;
  strong.setWeight(QFont::DemiBold);
  painter.setFont(strong);
  double room = upper.width();
  if (picture.stale) room -= 50;
  painter.drawText(upper, Qt::AlignVCenter,
                   QFontMetricsF(strong).elidedText(picture.name, Qt::ElideRight, room));
  painter.setFont(picture.font);
  if (picture.stale) {
    painter.setPen(colours.warning);
    painter.drawText(upper, Qt::AlignVCenter | Qt::AlignRight, words("changed"));
  }
  painter.setPen(colours.dimText);
  painter.drawText(QRectF(10, kFilmTop, kTimelineHeader - 20, kFilmBottom - kFilmTop), Qt::AlignVCenter,
                   picture.about);
  verticalLine(painter, kTimelineHeader - 0.5, 0, picture.size.height(), colours.line);
}

void paintRuler(QPainter& painter, const TimeBarPicture& picture, const QRect& dirty) {
  const Colours& colours = Theme::instance().colours();
  const double step = picture.axis.labelStep(kLabelDistance);
  painter.setFont(Theme::numberFont(-1.5));
  const double left = dirty.left() - kTimelineHeader - kLabelDistance;
  const double right = dirty.right() - kTimelineHeader + 4.0;
  const auto first = static_cast<long long>(std::floor(picture.axis.timeAt(left) / step));
  const auto last = static_cast<long long>(std::ceil(picture.axis.timeAt(right) / step));
  for (long long label = std::max(first, 0LL); label <= last; ++label) {
    const double time = static_cast<double>(label) * step;
    const double x = picture.xOf(time);
    for (int part = 1; part < 5; ++part)
      verticalLine(painter, picture.xOf(time + 0.2 * step * part), TimeBar::kRulerHeight - 4,
                   TimeBar::kRulerHeight, colours.line);
    verticalLine(painter, x, TimeBar::kLoopHeight + 3, TimeBar::kRulerHeight, colours.dimText);
    painter.setPen(colours.dimText);
    const QString text = timeLabel(time, step);
    if (x + 4.0 + painter.fontMetrics().horizontalAdvance(text) < picture.size.width())
      painter.drawText(QPointF(x + 4, TimeBar::kRulerHeight - 5), text);
  }
  horizontalLine(painter, kTimelineHeader, picture.size.width(), TimeBar::kRulerHeight, colours.line);
}

void paintLoop(QPainter& painter, const TimeBarPicture& picture) {
  const Colours& colours = Theme::instance().colours();
  painter.fillRect(QRectF(kTimelineHeader, 0, picture.size.width(), TimeBar::kLoopHeight),
                   mixed(colours.window, colours.field, 0.6));
  const std::optional<Playback::Range>& range = picture.loop;
  if (!range) return;
  const double from = picture.xOf(range->from);
  const double to = picture.xOf(range->to);
  const QColor colour = picture.loops ? colours.accent : colours.dimText;
  QColor band = colour;
  band.setAlphaF(0.45F);
  painter.fillRect(QRectF(from, 2, to - from, TimeBar::kLoopHeight - 4), band);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawRoundedRect(QRectF(from - 2, 0.5, 4, TimeBar::kLoopHeight - 1), 1.5, 1.5);
  painter.drawRoundedRect(QRectF(to - 2, 0.5, 4, TimeBar::kLoopHeight - 1), 1.5, 1.5);
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void paintStale(QPainter& painter, const TimeBarPicture& picture, const QRectF& film) {
  const Colours& colours = Theme::instance().colours();
  painter.save();
  painter.setClipRect(film, Qt::IntersectClip);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(mixed(colours.field, colours.warning, 0.45), 1.0));
  constexpr double kDistance = 9.0;
  const QRectF seen = film & QRectF(kTimelineHeader, film.top(), picture.size.width(), film.height());
  const double first = std::floor((seen.left() - film.height()) / kDistance) * kDistance;
  for (double x = first; x < seen.right(); x += kDistance)
    painter.drawLine(QPointF(x, film.bottom()), QPointF(x + film.height(), film.top()));
  painter.restore();
}

void paintFilm(QPainter& painter, const TimeBarPicture& picture) {
  const Colours& colours = Theme::instance().colours();
  const double end = picture.xOf(picture.axis.end());
  painter.fillRect(QRectF(picture.xOf(0.0), kFilmTop, end - picture.xOf(0.0), kFilmBottom - kFilmTop),
                   colours.field);
  const std::vector<FrameNote>& notes = picture.notes;
  if (notes.empty()) {
    painter.setPen(colours.dimText);
    painter.setFont(picture.font);
    painter.drawText(
        QRectF(kTimelineHeader, kFilmTop, picture.size.width() - kTimelineHeader, kFilmBottom - kFilmTop),
        Qt::AlignCenter,
        picture.nothingToSimulate ? words("Nothing to simulate yet.")
                                  : words("Nothing recorded yet. Press Space to simulate."));
    return;
  }
  const double from = picture.xOf(notes.front().time);
  const QRectF film(from, kFilmTop, picture.xOf(notes.back().time) - from, kFilmBottom - kFilmTop);
  painter.fillRect(film, mixed(colours.field, picture.stale ? colours.dimText : colours.accent,
                               picture.stale ? 0.22 : 0.3));
  if (picture.stale) paintStale(painter, picture, film);
  // Frames are told apart where there is room for it.
  if (notes.size() < 2 || film.width() / static_cast<double>(notes.size() - 1) < 6.0) return;
  const QColor line = mixed(colours.field, colours.text, 0.28);
  for (const FrameNote& note : notes) {
    const double x = picture.xOf(note.time);
    if (x >= kTimelineHeader && x <= picture.size.width())
      verticalLine(painter, x, kFilmBottom - 5, kFilmBottom, line);
  }
}

void paintTicks(QPainter& painter, const TimeBarPicture& picture, const QRect& dirty) {
  const QColor colour = Theme::instance().colours().bad;
  const auto first = static_cast<std::size_t>(std::max(dirty.left() - kTimelineHeader - 2, 0));
  const auto last = static_cast<std::size_t>(std::max(dirty.right() - kTimelineHeader + 2, 0));
  for (std::size_t pixel = first; pixel < std::min(last + 1, picture.breaks.size()); ++pixel) {
    const double height =
        (kFilmBottom - kFilmTop) * TimeBar::tickHeight(picture.breaks[pixel], picture.mostBreaks);
    if (height <= 0.0) continue;
    const double x = kTimelineHeader + static_cast<double>(pixel) + 0.5;
    verticalLine(painter, x, kFilmBottom - height, kFilmBottom, colour, 1.5);
  }
}

void paintCursor(QPainter& painter, const TimeBarPicture& picture) {
  const Colours& colours = Theme::instance().colours();
  verticalLine(painter, picture.cursorX, TimeBar::kLoopHeight + 4, picture.size.height(), colours.text, 1.5);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colours.text);
  const double x = picture.cursorX;
  const QPointF head[] = {{x - 5, TimeBar::kLoopHeight + 1},
                          {x + 5, TimeBar::kLoopHeight + 1},
                          {x + 5, TimeBar::kLoopHeight + 6},
                          {x, TimeBar::kLoopHeight + 12},
                          {x - 5, TimeBar::kLoopHeight + 6}};
  painter.drawPolygon(head, 5);
  painter.setRenderHint(QPainter::Antialiasing, false);
}

}  // namespace

double TimeBarPicture::xOf(double time) const {
  return kTimelineHeader + axis.xOf(time);
}

void paintTimeBar(QPainter& painter, const TimeBarPicture& picture, const QRect& dirty) {
  const Colours& colours = Theme::instance().colours();
  const QSize& size = picture.size;
  painter.fillRect(dirty, colours.panel);
  painter.fillRect(QRectF(0, 0, size.width(), TimeBar::kRulerHeight), colours.window);
  if (dirty.left() < kTimelineHeader) paintHeader(painter, picture);
  painter.setClipRect(dirty & QRect(kTimelineHeader, 0, size.width() - kTimelineHeader, size.height()));
  paintFilm(painter, picture);
  paintTicks(painter, picture, dirty);
  paintRuler(painter, picture, dirty);
  paintLoop(painter, picture);
  paintCursor(painter, picture);
}

}  // namespace ui
