#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "ui/session/playback.h"

namespace ui {

class NoteFeed;
class PlayActions;
class Session;
class TimeAxis;
struct TimeBarPicture;

/// The ruler and the take under it: what is recorded, where bonds broke, the loop range, and the cursor,
/// which follows the pointer while the left button is down.
class TimeBar : public QWidget {
  Q_OBJECT

 public:
  TimeBar(Session& session, TimeAxis& axis, NoteFeed& feed, PlayActions& actions, QWidget* parent = nullptr);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

  /// s: of the moment that is shown.
  double cursorTime() const;
  /// Where a moment is, in pixels of this widget.
  double xOf(double time) const;
  /// How high a tick of so many breaks is, of 1; logarithmic, so that one bond among thousands is seen.
  static double tickHeight(std::uint32_t breaks, std::uint32_t mostBreaks);

  static constexpr int kLoopHeight = 12;   ///< of the ruler, where the range is dragged
  static constexpr int kRulerHeight = 28;  ///< of all of it
  static constexpr int kFilmHeight = 34;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  bool event(QEvent* event) override;

 private:
  enum class Drag { none, scrub, pan, loopFrom, loopTo, loopNew };

  TimeBarPicture picture() const;
  void countBreaks(std::size_t from);
  void recount();
  void growFilm(std::size_t from);
  void moveCursor();
  void followState();
  void scrubTo(double x);
  void letGoOfOther();
  Drag dragAt(const QPointF& at) const;
  void dragLoop(double time);
  QString tipAt(const QPointF& at) const;
  QString staleReason() const;

  Session& session_;
  TimeAxis& axis_;
  NoteFeed& feed_;
  PlayActions& actions_;
  std::vector<std::uint32_t> breaks_;  ///< a pixel of the axis
  Drag drag_ = Drag::none;
  std::weak_ptr<Footage> dragged_;  ///< the take that the mouse holds
  double dragTime_ = 0.0;           ///< s: where a new range began
  double dragX_ = 0.0;
  double shownCursor_ = 0.0;  ///< px
  double shownEnd_ = 0.0;     ///< px: how far the film is painted
};

}  // namespace ui
