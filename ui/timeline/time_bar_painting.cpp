#include <QPaintEvent>
#include <QPainter>
#include <cmath>

#include "ui/session/session.h"
#include "ui/theme/theme.h"
#include "ui/timeline/note_feed.h"
#include "ui/timeline/time_axis.h"
#include "ui/timeline/time_bar.h"
#include "ui/timeline/time_painting.h"

namespace ui {
namespace {

constexpr double kFilmTop = TimeBar::kRulerHeight + 2.0;
constexpr double kFilmBottom = TimeBar::kRulerHeight + TimeBar::kFilmHeight;
constexpr double kLabelDistance = 72.0;

}  // namespace

void TimeBar::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  const Colours& colours = Theme::instance().colours();
  painter.fillRect(event->rect(), colours.panel);
  painter.fillRect(QRectF(0, 0, width(), kRulerHeight), colours.window);
  if (event->rect().left() < kTimelineHeader) paintHeader(painter);
  painter.setClipRect(event->rect() & QRect(kTimelineHeader, 0, width() - kTimelineHeader, height()));
  paintFilm(painter);
  paintTicks(painter, event->rect());
  paintRuler(painter, event->rect());
  paintLoop(painter);
  paintCursor(painter);
}

void TimeBar::paintHeader(QPainter& painter) {
  const Colours& colours = Theme::instance().colours();
  const std::optional<std::size_t> current = session_.takes().current();
  QString name = tr("No take yet");
  QString about = tr("Space simulates");
  bool stale = false;
  if (current) {
    const Take& take = session_.takes()[*current];
    name = take.name;
    stale = take.stale;
    about = tr("%1 frames, %2 s").arg(feed_.notes().size()).arg(take.footage->duration(), 0, 'f', 3);
  }
  const QRectF upper(10, 8, kTimelineHeader - 20, 18);
  painter.setPen(colours.text);
  QFont strong = font();
  strong.setWeight(QFont::DemiBold);
  painter.setFont(strong);
  double room = upper.width();
  if (stale) room -= 50;
  painter.drawText(upper, Qt::AlignVCenter, QFontMetricsF(strong).elidedText(name, Qt::ElideRight, room));
  painter.setFont(font());
  if (stale) {
    painter.setPen(colours.warning);
    painter.drawText(upper, Qt::AlignVCenter | Qt::AlignRight, tr("changed"));
  }
  painter.setPen(colours.dimText);
  painter.drawText(QRectF(10, kFilmTop, kTimelineHeader - 20, kFilmBottom - kFilmTop), Qt::AlignVCenter,
                   about);
  verticalLine(painter, kTimelineHeader - 0.5, 0, height(), colours.line);
}

void TimeBar::paintRuler(QPainter& painter, const QRect& dirty) {
  const Colours& colours = Theme::instance().colours();
  const double step = axis_.labelStep(kLabelDistance);
  painter.setFont(Theme::numberFont(-1.5));
  const double left = dirty.left() - kTimelineHeader - kLabelDistance;
  const double right = dirty.right() - kTimelineHeader + 4.0;
  const auto first = static_cast<long long>(std::floor(axis_.timeAt(left) / step));
  const auto last = static_cast<long long>(std::ceil(axis_.timeAt(right) / step));
  for (long long label = std::max(first, 0LL); label <= last; ++label) {
    const double time = static_cast<double>(label) * step;
    const double x = xOf(time);
    for (int part = 1; part < 5; ++part)
      verticalLine(painter, xOf(time + 0.2 * step * part), kRulerHeight - 4, kRulerHeight, colours.line);
    verticalLine(painter, x, kLoopHeight + 3, kRulerHeight, colours.dimText);
    painter.setPen(colours.dimText);
    const QString text = timeLabel(time, step);
    if (x + 4.0 + painter.fontMetrics().horizontalAdvance(text) < width())
      painter.drawText(QPointF(x + 4, kRulerHeight - 5), text);
  }
  horizontalLine(painter, kTimelineHeader, width(), kRulerHeight, colours.line);
}

void TimeBar::paintLoop(QPainter& painter) {
  const Colours& colours = Theme::instance().colours();
  painter.fillRect(QRectF(kTimelineHeader, 0, width(), kLoopHeight),
                   mixed(colours.window, colours.field, 0.6));
  const auto& range = session_.playback().loopRange();
  if (!range) return;
  const double from = xOf(range->from);
  const double to = xOf(range->to);
  const QColor colour = session_.playback().loops() ? colours.accent : colours.dimText;
  QColor band = colour;
  band.setAlphaF(0.45F);
  painter.fillRect(QRectF(from, 2, to - from, kLoopHeight - 4), band);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawRoundedRect(QRectF(from - 2, 0.5, 4, kLoopHeight - 1), 1.5, 1.5);
  painter.drawRoundedRect(QRectF(to - 2, 0.5, 4, kLoopHeight - 1), 1.5, 1.5);
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void TimeBar::paintFilm(QPainter& painter) {
  const Colours& colours = Theme::instance().colours();
  const double end = xOf(axis_.end());
  painter.fillRect(QRectF(xOf(0.0), kFilmTop, end - xOf(0.0), kFilmBottom - kFilmTop), colours.field);
  const std::vector<FrameNote>& notes = feed_.notes();
  if (notes.empty()) {
    const bool empty = session_.document().scene().parts.empty();
    painter.setPen(colours.dimText);
    painter.setFont(font());
    painter.drawText(
        QRectF(kTimelineHeader, kFilmTop, width() - kTimelineHeader, kFilmBottom - kFilmTop), Qt::AlignCenter,
        empty ? tr("Nothing to simulate yet.") : tr("Nothing recorded yet. Press Space to simulate."));
    return;
  }
  shownEnd_ = xOf(notes.back().time);
  const QRectF film(xOf(notes.front().time), kFilmTop, shownEnd_ - xOf(notes.front().time),
                    kFilmBottom - kFilmTop);
  const std::optional<std::size_t> current = session_.takes().current();
  const bool stale = current && session_.takes()[*current].stale;
  painter.fillRect(film, mixed(colours.field, stale ? colours.dimText : colours.accent, stale ? 0.22 : 0.3));
  if (stale) paintStale(painter, film);
  // Frames are told apart where there is room for it.
  if (notes.size() < 2 || film.width() / static_cast<double>(notes.size() - 1) < 6.0) return;
  const QColor line = mixed(colours.field, colours.text, 0.28);
  for (const FrameNote& note : notes) {
    const double x = xOf(note.time);
    if (x >= kTimelineHeader && x <= width()) verticalLine(painter, x, kFilmBottom - 5, kFilmBottom, line);
  }
}

void TimeBar::paintStale(QPainter& painter, const QRectF& film) {
  const Colours& colours = Theme::instance().colours();
  painter.save();
  painter.setClipRect(film, Qt::IntersectClip);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(mixed(colours.field, colours.warning, 0.45), 1.0));
  constexpr double kDistance = 9.0;
  const QRectF seen = film & QRectF(kTimelineHeader, film.top(), width(), film.height());
  const double first = std::floor((seen.left() - film.height()) / kDistance) * kDistance;
  for (double x = first; x < seen.right(); x += kDistance)
    painter.drawLine(QPointF(x, film.bottom()), QPointF(x + film.height(), film.top()));
  painter.restore();
}

void TimeBar::paintTicks(QPainter& painter, const QRect& dirty) {
  const QColor colour = Theme::instance().colours().bad;
  const auto first = static_cast<std::size_t>(std::max(dirty.left() - kTimelineHeader - 2, 0));
  const auto last = static_cast<std::size_t>(std::max(dirty.right() - kTimelineHeader + 2, 0));
  for (std::size_t pixel = first; pixel < std::min(last + 1, breaks_.size()); ++pixel) {
    const double height = (kFilmBottom - kFilmTop) * tickHeight(breaks_[pixel], feed_.mostBreaks());
    if (height <= 0.0) continue;
    const double x = kTimelineHeader + static_cast<double>(pixel) + 0.5;
    verticalLine(painter, x, kFilmBottom - height, kFilmBottom, colour, 1.5);
  }
}

void TimeBar::paintCursor(QPainter& painter) {
  const Colours& colours = Theme::instance().colours();
  verticalLine(painter, shownCursor_, kLoopHeight + 4, height(), colours.text, 1.5);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colours.text);
  const double x = shownCursor_;
  const QPointF head[] = {{x - 5, kLoopHeight + 1},
                          {x + 5, kLoopHeight + 1},
                          {x + 5, kLoopHeight + 6},
                          {x, kLoopHeight + 12},
                          {x - 5, kLoopHeight + 6}};
  painter.drawPolygon(head, 5);
  painter.setRenderHint(QPainter::Antialiasing, false);
}

}  // namespace ui
