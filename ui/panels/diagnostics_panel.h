#pragma once

#include <QPointF>
#include <QTimer>
#include <QWidget>
#include <vector>

#include "ui/panels/plots.h"

class QButtonGroup;
class QCheckBox;
class QGraphicsLineItem;
class QGridLayout;
class QLabel;
QT_BEGIN_NAMESPACE
class QChart;
class QChartView;
class QLineSeries;
class QValueAxis;
QT_END_NAMESPACE

namespace ui {

class NoteFeed;
class Session;
class TimeAxis;

/// Plots of the take on the timeline, over the stretch of time that the timeline shows, with the numbers of
/// the present frame. A click goes to that moment. Drawn anew a few times a second at most, and only while it
/// can be seen.
class DiagnosticsPanel : public QWidget {
  Q_OBJECT

 public:
  DiagnosticsPanel(Session& session, NoteFeed& feed, TimeAxis& axis, QWidget* parent = nullptr);

  /// Counted in allPlots().
  void showPlot(std::size_t plot);
  std::size_t shownPlot() const { return plot_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void makeChart();
  void colour();
  void makeLines();
  void plotSoon();
  void plotNow();
  void fitValues(QValueAxis& axis, bool ofItsOwn, std::vector<QList<QPointF>>& points);
  void showCursor();
  std::size_t presentFrame() const;

  struct Line {
    QLineSeries* series = nullptr;
    QCheckBox* box = nullptr;
    QLabel* value = nullptr;
  };

  Session& session_;
  NoteFeed& feed_;
  TimeAxis& axis_;
  const std::vector<Plot> plots_ = allPlots();
  std::size_t plot_ = 0;
  std::vector<Line> lines_;
  QChart* chart_ = nullptr;
  QChartView* view_ = nullptr;
  QValueAxis* time_ = nullptr;
  QValueAxis* values_ = nullptr;
  QValueAxis* others_ = nullptr;  ///< of what has an axis of its own
  QGraphicsLineItem* cursor_ = nullptr;
  QButtonGroup* choice_ = nullptr;
  QGridLayout* legend_ = nullptr;
  QLabel* unit_ = nullptr;
  QTimer timer_;
};

}  // namespace ui
