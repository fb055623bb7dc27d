#pragma once

#include <QWidget>

#include "ui/timeline/note_feed.h"
#include "ui/timeline/time_axis.h"

namespace ui {

class PlayActions;
class Session;
class TimeBar;
class Transport;

/// Transport, ruler and take, and the tracks of the scene.
class Timeline : public QWidget {
  Q_OBJECT

 public:
  Timeline(Session& session, PlayActions& actions, QWidget* parent = nullptr);

  TimeAxis& axis() { return axis_; }
  NoteFeed& feed() { return feed_; }
  TimeBar& bar() { return *bar_; }

 private:
  void fitAxis();

  Session& session_;
  TimeAxis axis_;
  NoteFeed feed_;
  Transport* transport_ = nullptr;
  TimeBar* bar_ = nullptr;
};

}  // namespace ui
