#pragma once

#include <QWidget>

class QAction;
class QMenu;
class QScrollArea;

#include "ui/timeline/note_feed.h"
#include "ui/timeline/time_axis.h"

namespace ui {

class PlayActions;
class Session;
class TimeBar;
class TrackRows;
class Transport;

/// Transport, ruler and take, and the tracks of the scene.
class Timeline : public QWidget {
  Q_OBJECT

 public:
  Timeline(Session& session, PlayActions& actions, QWidget* parent = nullptr);

  TimeAxis& axis() { return axis_; }
  NoteFeed& feed() { return feed_; }
  TimeBar& bar() { return *bar_; }
  TrackRows& rows() { return *rows_; }
  /// Shows the rows of the tracks.
  QAction* showTracks() { return showTracks_; }

 private:
  void makeTracks();
  void fillTargets();
  void fitAxis();
  void fitTracks();

  Session& session_;
  TimeAxis axis_;
  NoteFeed feed_;
  Transport* transport_ = nullptr;
  TimeBar* bar_ = nullptr;
  TrackRows* rows_ = nullptr;
  QScrollArea* scroll_ = nullptr;
  QAction* showTracks_ = nullptr;
  QAction* addTrack_ = nullptr;
  QMenu* targets_ = nullptr;
  std::size_t trackCount_ = 0;
};

}  // namespace ui
