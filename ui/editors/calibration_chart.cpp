#include "ui/editors/calibration_chart.h"

#include <QChart>
#include <QChartView>
#include <QCoreApplication>
#include <QLegendMarker>
#include <QLineSeries>
#include <QLogValueAxis>
#include <QScatterSeries>
#include <QVBoxLayout>
#include <QValueAxis>
#include <algorithm>
#include <cmath>

#include "ui/theme/theme.h"

namespace ui {
namespace {

using modeling::TrialVerdict;

constexpr std::array kVerdicts{TrialVerdict::holds, TrialVerdict::breaks, TrialVerdict::crumbles};

QColor colourOf(TrialVerdict verdict) {
  const Colours& colours = Theme::instance().colours();
  switch (verdict) {
    case TrialVerdict::holds:
      return colours.accent;
    case TrialVerdict::breaks:
      return colours.good;
    case TrialVerdict::crumbles:
      return colours.bad;
  }
  return colours.text;
}

}  // namespace

QString verdictText(TrialVerdict verdict) {
  switch (verdict) {
    case TrialVerdict::holds:
      return QCoreApplication::translate("calibration", "Holds");
    case TrialVerdict::breaks:
      return QCoreApplication::translate("calibration", "Breaks");
    case TrialVerdict::crumbles:
      return QCoreApplication::translate("calibration", "Crumbles");
  }
  return {};
}

CalibrationChart::CalibrationChart(QWidget* parent) : QWidget(parent) {
  chart_ = new QChart;
  chart_->setMargins({4, 4, 4, 4});
  chart_->layout()->setContentsMargins(0, 0, 0, 0);
  chart_->setBackgroundRoundness(4.0);
  view_ = new QChartView(chart_, this);
  view_->setRenderHint(QPainter::Antialiasing);
  view_->setFrameShape(QFrame::NoFrame);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(view_);
  makeAxes();
  makeSeries();
  connect(&Theme::instance(), &Theme::changed, this, &CalibrationChart::colour);
  colour();
  plot({});
}

void CalibrationChart::makeAxes() {
  threshold_ = new QLogValueAxis(chart_);
  threshold_->setBase(10.0);
  threshold_->setLabelFormat(QStringLiteral("%g"));
  threshold_->setMinorTickCount(8);
  threshold_->setTitleText(tr("Threshold: strain at which a bond breaks"));
  fragments_ = new QValueAxis(chart_);
  fragments_->setLabelFormat(QStringLiteral("%d"));
  fragments_->setTitleText(tr("Pieces"));
  share_ = new QValueAxis(chart_);
  share_->setRange(0.0, 100.0);
  share_->setTickCount(3);
  share_->setLabelFormat(QStringLiteral("%d"));
  share_->setTitleText(tr("Grains, % of nodes"));
  chart_->addAxis(threshold_, Qt::AlignBottom);
  chart_->addAxis(fragments_, Qt::AlignLeft);
  chart_->addAxis(share_, Qt::AlignRight);
}

void CalibrationChart::makeSeries() {
  const auto add = [&](QXYSeries* series, const QString& name, QValueAxis* axis) {
    series->setName(name);
    chart_->addSeries(series);
    series->attachAxis(threshold_);
    series->attachAxis(axis);
  };
  grains_ = new QLineSeries(chart_);
  add(grains_, tr("Grains"), share_);
  pieces_ = new QLineSeries(chart_);
  add(pieces_, tr("Pieces"), fragments_);
  chosen_ = new QLineSeries(chart_);
  add(chosen_, tr("Offered"), share_);
  for (std::size_t i = 0; i < kVerdicts.size(); ++i) {
    verdicts_[i] = new QScatterSeries(chart_);
    verdicts_[i]->setMarkerSize(10.0);
    add(verdicts_[i], verdictText(kVerdicts[i]), fragments_);
  }
  // What a point's colour says comes with the points themselves.
  for (QAbstractSeries* series :
       {static_cast<QAbstractSeries*>(pieces_), static_cast<QAbstractSeries*>(chosen_)})
    for (QLegendMarker* marker : chart_->legend()->markers(series)) marker->setVisible(false);
  chart_->legend()->setAlignment(Qt::AlignTop);
}

void CalibrationChart::colour() {
  const Colours& colours = Theme::instance().colours();
  chart_->setBackgroundBrush(colours.field);
  view_->setBackgroundBrush(colours.panel);
  chart_->legend()->setLabelColor(colours.text);
  for (QAbstractAxis* axis : {static_cast<QAbstractAxis*>(threshold_),
                              static_cast<QAbstractAxis*>(fragments_), static_cast<QAbstractAxis*>(share_)}) {
    axis->setLabelsColor(colours.dimText);
    axis->setTitleBrush(colours.dimText);
    axis->setLinePenColor(colours.line);
    axis->setGridLineColor(colours.line);
    axis->setMinorGridLineVisible(false);
    axis->setLabelsFont(Theme::numberFont(-1.5));
    axis->setTitleFont(QFont());
  }
  share_->setGridLineVisible(false);
  pieces_->setPen(QPen(colours.dimText, 1.6));
  grains_->setPen(QPen(colours.warning, 1.6, Qt::DashLine));
  chosen_->setPen(QPen(colours.good, 2.0));
  for (std::size_t i = 0; i < kVerdicts.size(); ++i) {
    verdicts_[i]->setColor(colourOf(kVerdicts[i]));
    verdicts_[i]->setBorderColor(colours.field);
  }
}

void CalibrationChart::fitAxes(const CalibrationProgress& progress, double most) {
  fragments_->setRange(0.0, std::max(4.0, std::ceil(most * 1.15 / 4.0) * 4.0));
  fragments_->setTickCount(5);
  if (progress.trials.empty()) return threshold_->setRange(0.001, 1.0);
  double low = progress.trials.front().threshold;
  double high = low;
  for (const modeling::Trial& trial : progress.trials) {
    low = std::min(low, trial.threshold);
    high = std::max(high, trial.threshold);
  }
  threshold_->setRange(std::min(low / 1.3, high / 12.0), high * 1.3);
}

void CalibrationChart::plot(const CalibrationProgress& progress) {
  QList<QPointF> pieces;
  QList<QPointF> grains;
  std::array<QList<QPointF>, 3> points;
  double most = 1.0;
  for (const modeling::Trial& trial : progress.trials) {
    const auto count = static_cast<double>(trial.fragments);
    pieces.append({trial.threshold, count});
    grains.append({trial.threshold, 100.0 * trial.isolatedShare});
    points[static_cast<std::size_t>(trial.verdict)].append({trial.threshold, count});
    most = std::max(most, count);
  }
  fitAxes(progress, most);
  pieces_->replace(pieces);
  grains_->replace(grains);
  for (std::size_t i = 0; i < points.size(); ++i) verdicts_[i]->replace(points[i]);
  chosen_->replace(progress.threshold
                       ? QList<QPointF>{{*progress.threshold, 0.0}, {*progress.threshold, 100.0}}
                       : QList<QPointF>{});
}

std::size_t CalibrationChart::pointCount() const {
  std::size_t count = 0;
  for (const QScatterSeries* series : verdicts_) count += static_cast<std::size_t>(series->count());
  return count;
}

}  // namespace ui
