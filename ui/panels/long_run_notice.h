#pragma once

#include <QElapsedTimer>
#include <QWidget>

#include "ui/session/session.h"

class QLabel;

namespace ui {

/// Asks, over the viewport, whether a run that turns out to take minutes is to go on. The run goes on
/// meanwhile: nothing is lost by thinking about it.
class LongRunNotice : public QWidget {
  Q_OBJECT

 public:
  /// `over` is what it stands at the foot of.
  LongRunNotice(Session& session, QWidget* over);

 signals:
  void preflightWanted();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void showRun();
  void place();

  Session& session_;
  QLabel* text_;
  QElapsedTimer running_;
  std::uint64_t run_ = 0;
  bool answered_ = false;  ///< about this run
};

}  // namespace ui
