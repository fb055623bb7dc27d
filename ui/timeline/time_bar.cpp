#include "ui/timeline/time_bar.h"

#include <QHelpEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <cmath>

#include "ui/session/session.h"
#include "ui/timeline/note_feed.h"
#include "ui/timeline/play_actions.h"
#include "ui/timeline/scene_difference.h"
#include "ui/timeline/time_axis.h"
#include "ui/timeline/time_bar_painting.h"
#include "ui/timeline/time_painting.h"

namespace ui {
namespace {

/// px: half of what is painted for the cursor, and how near one has to point at a handle.
constexpr double kCursorReach = 7.0;
constexpr double kHandleReach = 6.0;
/// A notch of the wheel.
constexpr double kZoomPerNotch = 0.8;

}  // namespace

TimeBar::TimeBar(Session& session, TimeAxis& axis, NoteFeed& feed, PlayActions& actions, QWidget* parent)
    : QWidget(parent), session_(session), axis_(axis), feed_(feed), actions_(actions) {
  setObjectName(QStringLiteral("timeBar"));
  setMouseTracking(true);
  setFocusPolicy(Qt::ClickFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Timeline"));
  connect(&axis_, &TimeAxis::changed, this, &TimeBar::recount);
  connect(&feed_, &NoteFeed::reset, this, &TimeBar::recount);
  connect(&feed_, &NoteFeed::grown, this, &TimeBar::growFilm);
  connect(&session_, &Session::shownChanged, this, &TimeBar::moveCursor);
  connect(&session_.takes(), &TakeList::changed, this, qOverload<>(&QWidget::update));
  connect(&session_.document(), &Document::sceneChanged, this, &TimeBar::followState);
  connect(&session_.playback(), &Playback::frameChanged, this, &TimeBar::moveCursor);
  connect(&session_.playback(), &Playback::stateChanged, this, &TimeBar::followState);
  connect(&session_.playback(), &Playback::stateChanged, this, &TimeBar::letGoOfOther);
}

QSize TimeBar::sizeHint() const {
  return {900, kRulerHeight + kFilmHeight + 4};
}

QSize TimeBar::minimumSizeHint() const {
  return {kTimelineHeader + 240, kRulerHeight + kFilmHeight + 4};
}

double TimeBar::cursorTime() const {
  if (session_.followsRun() && session_.shown().live && session_.shown().moment)
    return session_.shown().moment->time;
  // That of the frame, not of the clock, which in slow motion runs on between two.
  const std::size_t frame = session_.playback().frame();
  return frame < feed_.notes().size() ? feed_.notes()[frame].time : 0.0;
}

double TimeBar::xOf(double time) const {
  return kTimelineHeader + axis_.xOf(time);
}

double TimeBar::tickHeight(std::uint32_t breaks, std::uint32_t mostBreaks) {
  if (breaks == 0) return 0.0;
  const double most = std::log1p(static_cast<double>(std::max(mostBreaks, breaks)));
  return 0.15 + 0.85 * std::log1p(static_cast<double>(breaks)) / most;
}

void TimeBar::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  paintTimeBar(painter, picture(), event->rect());
  if (!feed_.notes().empty()) shownEnd_ = xOf(feed_.notes().back().time);
}

TimeBarPicture TimeBar::picture() const {
  const std::optional<std::size_t> current = session_.takes().current();
  const Take* take = current ? &session_.takes()[*current] : nullptr;
  const std::vector<FrameNote>& notes = feed_.notes();
  return {axis_,
          notes,
          breaks_,
          feed_.mostBreaks(),
          take != nullptr            ? take->name
          : session_.takes().empty() ? tr("No take yet")
                                     : tr("No take chosen"),
          take != nullptr ? tr("%1 frames, %2 s").arg(notes.size()).arg(take->footage->duration(), 0, 'f', 3)
          : session_.takes().empty()
              ? tr("Space simulates")
              : tr("%n in the list", nullptr, static_cast<int>(session_.takes().size())),
          take != nullptr && take->stale,
          session_.document().scene().parts.empty(),
          session_.playback().loopRange(),
          session_.playback().loops(),
          shownCursor_,
          size(),
          font()};
}

void TimeBar::resizeEvent(QResizeEvent*) {
  axis_.setWidth(width() - kTimelineHeader);
}

void TimeBar::countBreaks(std::size_t from) {
  const std::vector<FrameNote>& notes = feed_.notes();
  for (std::size_t frame = from; frame < notes.size(); ++frame) {
    const double x = std::floor(axis_.xOf(notes[frame].time));
    if (x < 0.0 || x >= static_cast<double>(breaks_.size())) continue;
    breaks_[static_cast<std::size_t>(x)] += notes[frame].breaks;
  }
}

void TimeBar::recount() {
  breaks_.assign(static_cast<std::size_t>(std::max(axis_.width(), 0.0)) + 1, 0);
  countBreaks(0);
  shownCursor_ = xOf(cursorTime());
  update();
}

/// Where more is recorded, only that is drawn, unless ticks become smaller by what came.
void TimeBar::growFilm(std::size_t from) {
  countBreaks(from);
  const std::vector<FrameNote>& notes = feed_.notes();
  const auto isMost = [&](const FrameNote& note) {
    return note.breaks == feed_.mostBreaks() && note.breaks > 0;
  };
  const auto first = notes.begin() + static_cast<std::ptrdiff_t>(from);
  if (from == 0 || std::any_of(first, notes.end(), isMost)) {
    update();
    return;
  }
  const int left = static_cast<int>(shownEnd_) - 3;
  update(QRect(left, kRulerHeight, static_cast<int>(xOf(notes.back().time)) + 3 - left, kFilmHeight + 4));
  update(QRect(0, 0, kTimelineHeader, height()));
}

void TimeBar::moveCursor() {
  const double x = xOf(cursorTime());
  const auto strip = [&](double at) {
    return QRectF(at - kCursorReach, 0.0, 2.0 * kCursorReach, height()).toAlignedRect();
  };
  update(strip(shownCursor_));
  shownCursor_ = x;
  update(strip(shownCursor_));
}

void TimeBar::followState() {
  // What is said in place of a take is another for a scene with nothing in it.
  update(feed_.notes().empty() ? rect() : QRect(0, 0, width(), kRulerHeight + 2));
}

void TimeBar::scrubTo(double x) {
  const std::vector<FrameNote>& notes = feed_.notes();
  if (notes.empty()) return;
  const double time = axis_.timeAt(x - kTimelineHeader);
  Playback& playback = session_.playback();
  std::size_t frame = playback.footage()->frameAt(time);
  if (frame + 1 < notes.size() && notes[frame + 1].time - time < time - notes[frame].time) ++frame;
  playback.stop();
  playback.seek(frame);
}

/// A take that comes in place of the one that was dragged along is not what the person holds.
void TimeBar::letGoOfOther() {
  if (drag_ == Drag::none || drag_ == Drag::pan) return;
  if (session_.playback().footage() != dragged_.lock()) drag_ = Drag::none;
}

TimeBar::Drag TimeBar::dragAt(const QPointF& at) const {
  if (at.x() < kTimelineHeader) return Drag::none;
  if (at.y() >= kLoopHeight) return Drag::scrub;
  if (const auto& range = session_.playback().loopRange()) {
    if (std::abs(at.x() - xOf(range->to)) <= kHandleReach) return Drag::loopTo;
    if (std::abs(at.x() - xOf(range->from)) <= kHandleReach) return Drag::loopFrom;
  }
  return Drag::loopNew;
}

void TimeBar::mousePressEvent(QMouseEvent* event) {
  dragX_ = event->position().x();
  if (event->button() == Qt::MiddleButton) drag_ = Drag::pan;
  if (event->button() != Qt::LeftButton) return;
  drag_ = dragAt(event->position());
  dragged_ = session_.playback().footage();
  dragTime_ = std::clamp(axis_.timeAt(dragX_ - kTimelineHeader), 0.0, axis_.end());
  if (drag_ == Drag::scrub) scrubTo(dragX_);
}

void TimeBar::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->position().x();
  // A release that another window got is seen by the buttons.
  if (event->buttons() == Qt::NoButton) drag_ = Drag::none;
  if (drag_ == Drag::none) {
    const Drag over = dragAt(event->position());
    const bool handle = over == Drag::loopFrom || over == Drag::loopTo;
    setCursor(handle ? Qt::SizeHorCursor : Qt::ArrowCursor);
  } else if (drag_ == Drag::scrub) {
    scrubTo(x);
  } else if (drag_ == Drag::pan) {
    axis_.pan(std::exchange(dragX_, x) - x);
  } else {
    dragLoop(std::clamp(axis_.timeAt(x - kTimelineHeader), 0.0, axis_.end()));
  }
}

void TimeBar::dragLoop(double time) {
  Playback& playback = session_.playback();
  Playback::Range range = playback.loopRange().value_or(Playback::Range{});
  if (drag_ == Drag::loopNew) {
    range = {std::min(dragTime_, time), std::max(dragTime_, time)};
  } else if (drag_ == Drag::loopFrom) {
    range.from = std::min(time, range.to);
  } else {
    range.to = std::max(time, range.from);
  }
  if (range.to - range.from < 2.0 * axis_.secondsPerPixel()) return;
  playback.setLoopRange(range);
  playback.setLoops(true);
}

void TimeBar::mouseReleaseEvent(QMouseEvent*) {
  drag_ = Drag::none;
}

void TimeBar::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (event->position().x() > kTimelineHeader && event->position().y() < kLoopHeight) {
    session_.playback().setLoopRange(std::nullopt);
  } else {
    mousePressEvent(event);
  }
}

void TimeBar::wheelEvent(QWheelEvent* event) {
  const QPoint turn = event->angleDelta();
  const double notches = turn.y() / 120.0;
  const bool sideways = std::abs(turn.x()) > std::abs(turn.y());
  if (sideways || event->modifiers().testFlag(Qt::ShiftModifier)) {
    axis_.pan(-(sideways ? turn.x() : turn.y()) / 120.0 * 60.0);
  } else {
    axis_.zoom(std::pow(kZoomPerNotch, notches), event->position().x() - kTimelineHeader);
  }
  event->accept();
}

void TimeBar::contextMenuEvent(QContextMenuEvent* event) {
  QMenu menu(this);
  menu.addAction(actions_.continueAsWas);
  menu.addAction(actions_.continueChanged);
  menu.addSeparator();
  menu.addAction(actions_.toFirstBreak);
  menu.addAction(actions_.loop);
  QAction* clear = menu.addAction(tr("Clear Loop Range"));
  clear->setEnabled(session_.playback().loopRange().has_value());
  connect(clear, &QAction::triggered, this, [this] { session_.playback().setLoopRange(std::nullopt); });
  menu.addSeparator();
  QAction* all = menu.addAction(tr("Show All of the Time"));
  all->setEnabled(!axis_.showsAll());
  connect(all, &QAction::triggered, &axis_, &TimeAxis::showAll);
  menu.exec(event->globalPos());
}

bool TimeBar::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QToolTip::showText(help->globalPos(), tipAt(QPointF(help->pos())), this);
  return true;
}

QString TimeBar::staleReason() const {
  const std::optional<std::size_t> current = session_.takes().current();
  if (!current || !session_.takes()[*current].stale) return {};
  const QStringList differences =
      differencesOf(*session_.takes()[*current].footage->scene(), session_.document().scene());
  if (differences.isEmpty()) return tr("The scene has been changed since.");
  return tr("Changed since: %1.").arg(differences.join(QStringLiteral(", ")));
}

QString TimeBar::tipAt(const QPointF& at) const {
  const std::vector<FrameNote>& notes = feed_.notes();
  if (at.x() < kTimelineHeader) return staleReason();
  if (at.y() < kLoopHeight) return tr("Drag to choose a range to loop; double-click to clear it");
  const double time = axis_.timeAt(at.x() - kTimelineHeader);
  if (notes.empty() || time < 0.0 || time > notes.back().time) return tr("Wheel: zoom. Middle button: move.");
  const std::size_t frame = session_.playback().footage()->frameAt(time);
  QString tip = tr("Frame %1, %2 s").arg(frame).arg(notes[frame].time, 0, 'f', 4);
  const auto pixel = static_cast<std::size_t>(std::max(at.x() - kTimelineHeader, 0.0));
  std::uint32_t broke = 0;
  for (std::size_t near = pixel > 1 ? pixel - 2 : 0; near < std::min(pixel + 3, breaks_.size()); ++near)
    broke += breaks_[near];
  if (broke > 0)
    tip +=
        QStringLiteral("\n") + (broke == 1 ? tr("1 bond broke here") : tr("%1 bonds broke here").arg(broke));
  const QString stale = staleReason();
  return stale.isEmpty() ? tip : tip + QStringLiteral("\n") + stale;
}

}  // namespace ui
