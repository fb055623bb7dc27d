#pragma once

#include <QWidget>
#include <array>

#include "ui/editors/calibration_run.h"

QT_BEGIN_NAMESPACE
class QChart;
class QChartView;
class QLineSeries;
class QLogValueAxis;
class QScatterSeries;
class QValueAxis;
QT_END_NAMESPACE

namespace ui {

/// Trials by threshold: into how many pieces a sample broke, and what share of it went to grains.
class CalibrationChart : public QWidget {
  Q_OBJECT

 public:
  explicit CalibrationChart(QWidget* parent = nullptr);

  void plot(const CalibrationProgress& progress);
  std::size_t pointCount() const;

 private:
  void makeAxes();
  void makeSeries();
  void colour();
  void fitAxes(const CalibrationProgress& progress, double most);

  QChart* chart_ = nullptr;
  QChartView* view_ = nullptr;
  QLogValueAxis* threshold_ = nullptr;
  QValueAxis* fragments_ = nullptr;
  QValueAxis* share_ = nullptr;
  QLineSeries* pieces_ = nullptr;
  QLineSeries* grains_ = nullptr;
  QLineSeries* chosen_ = nullptr;
  std::array<QScatterSeries*, 3> verdicts_{};  ///< by modeling::TrialVerdict
};

/// "holds", "breaks" or "crumbles" for people.
QString verdictText(modeling::TrialVerdict verdict);

}  // namespace ui
