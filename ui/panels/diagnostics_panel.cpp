#include "ui/panels/diagnostics_panel.h"

#include <QButtonGroup>
#include <QChart>
#include <QChartView>
#include <QCheckBox>
#include <QGraphicsLineItem>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineSeries>
#include <QMouseEvent>
#include <QToolButton>
#include <QVBoxLayout>
#include <QValueAxis>
#include <algorithm>
#include <cmath>

#include "ui/session/session.h"
#include "ui/theme/theme.h"
#include "ui/timeline/note_feed.h"
#include "ui/timeline/time_axis.h"

namespace ui {
namespace {

constexpr int kPlotMilliseconds = 120;

struct Thousands {
  double factor = 1.0;
  QString prefix;
};

Thousands thousandsOf(double most) {
  if (most >= 1e12) return {1e12, QStringLiteral("\u00d710\u00b9\u00b2")};
  if (most >= 1e9) return {1e9, QStringLiteral("\u00d710\u2079")};
  if (most >= 1e6) return {1e6, QStringLiteral("\u00d710\u2076")};
  if (most >= 1e4) return {1e3, QStringLiteral("\u00d710\u00b3")};
  return {1.0, {}};
}

/// 1, 2 or 5 times a power of ten, at least this.
double niceStep(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(std::max(least, 1e-12))));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10.0 * power;
}

/// Charts make a label for every tick of the range they have: an interval that does not belong to it could
/// ask for more than there is memory.
void setRange(QValueAxis& axis, double from, double to, double ticks) {
  const double end = to > from ? to : from + 1.0;
  axis.setTickInterval(niceStep((end - from) / ticks));
  axis.setRange(from, end);
}

}  // namespace

DiagnosticsPanel::DiagnosticsPanel(Session& session, NoteFeed& feed, TimeAxis& axis, QWidget* parent)
    : QWidget(parent), session_(session), feed_(feed), axis_(axis) {
  setObjectName(QStringLiteral("diagnostics"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 6, 12, 6);
  row->setSpacing(8);
  auto* names = new QVBoxLayout;
  names->setSpacing(2);
  choice_ = new QButtonGroup(this);
  for (std::size_t plot = 0; plot < plots_.size(); ++plot) {
    auto* button = new QToolButton(this);
    button->setText(plots_[plot].name);
    button->setCheckable(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setFixedHeight(26);
    choice_->addButton(button, static_cast<int>(plot));
    names->addWidget(button);
  }
  names->addStretch(1);
  row->addLayout(names);
  makeChart();
  row->addWidget(view_, 1);
  auto* side = new QVBoxLayout;
  unit_ = new QLabel(this);
  unit_->setForegroundRole(QPalette::PlaceholderText);
  unit_->setAlignment(Qt::AlignRight);
  legend_ = new QGridLayout;
  legend_->setVerticalSpacing(2);
  legend_->setHorizontalSpacing(10);
  side->addWidget(unit_);
  side->addLayout(legend_);
  side->addStretch(1);
  row->addLayout(side);
  timer_.setSingleShot(true);
  timer_.setInterval(kPlotMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &DiagnosticsPanel::plotNow);
  connect(choice_, &QButtonGroup::idClicked, this,
          [this](int plot) { showPlot(static_cast<std::size_t>(plot)); });
  connect(&feed_, &NoteFeed::reset, this, &DiagnosticsPanel::plotSoon);
  connect(&feed_, &NoteFeed::grown, this, &DiagnosticsPanel::plotSoon);
  connect(&axis_, &TimeAxis::changed, this, &DiagnosticsPanel::plotSoon);
  connect(&session_, &Session::shownChanged, this, &DiagnosticsPanel::showCursor);
  connect(&Theme::instance(), &Theme::changed, this, &DiagnosticsPanel::colour);
  showPlot(0);
}

void DiagnosticsPanel::makeChart() {
  chart_ = new QChart;
  chart_->legend()->hide();
  chart_->setMargins({0, 0, 0, 0});
  chart_->setBackgroundVisible(false);
  chart_->setContentsMargins(-4, -6, -4, -8);
  time_ = new QValueAxis(chart_);
  values_ = new QValueAxis(chart_);
  others_ = new QValueAxis(chart_);
  chart_->addAxis(time_, Qt::AlignBottom);
  chart_->addAxis(values_, Qt::AlignLeft);
  chart_->addAxis(others_, Qt::AlignRight);
  for (QValueAxis* axis : {time_, values_, others_}) {
    axis->setLabelsFont(Theme::numberFont(-2.0));
    axis->setTitleFont(Theme::numberFont(-1.0));
    axis->setLabelFormat(QStringLiteral("%.4g"));
    setRange(*axis, 0.0, 1.0, 4.0);
    axis->setTickAnchor(0.0);
    axis->setTickType(QValueAxis::TicksDynamic);
  }
  others_->setGridLineVisible(false);
  view_ = new QChartView(chart_, this);
  view_->setRenderHint(QPainter::Antialiasing);
  view_->setFrameShape(QFrame::NoFrame);
  view_->setFocusPolicy(Qt::NoFocus);
  view_->setBackgroundBrush(Qt::NoBrush);
  view_->setStyleSheet(QStringLiteral("background: transparent;"));
  view_->setMinimumSize(240, 110);
  view_->setToolTip(tr("Click: go to that moment. The wheel over the timeline zooms."));
  view_->viewport()->installEventFilter(this);
  cursor_ = new QGraphicsLineItem(chart_);
  cursor_->setZValue(20.0);
}

void DiagnosticsPanel::colour() {
  const Colours& colours = Theme::instance().colours();
  for (QValueAxis* axis : {time_, values_, others_}) {
    axis->setLabelsColor(colours.dimText);
    axis->setTitleBrush(colours.dimText);
    axis->setLinePenColor(colours.line);
    axis->setGridLineColor(colours.line);
  }
  cursor_->setPen(QPen(colours.text, 1.2));
  for (std::size_t line = 0; line < lines_.size(); ++line) {
    const QColor shown = plotColour(line);
    lines_[line].series->setPen(QPen(shown, 1.7));
    QPixmap swatch(12, 12);
    swatch.fill(shown);
    lines_[line].box->setIcon(QIcon(swatch));
  }
}

void DiagnosticsPanel::showPlot(std::size_t plot) {
  plot_ = plot;
  choice_->button(static_cast<int>(plot))->setChecked(true);
  makeLines();
  colour();
  plotNow();
}

void DiagnosticsPanel::makeLines() {
  for (const Line& line : lines_) {
    chart_->removeSeries(line.series);
    delete line.series;
    delete line.box;
    delete line.value;
  }
  lines_.clear();
  const Plot& plot = plots_[plot_];
  bool other = false;
  for (std::size_t place = 0; place < plot.lines.size(); ++place) {
    Line line;
    line.series = new QLineSeries(chart_);
    chart_->addSeries(line.series);
    line.series->attachAxis(time_);
    line.series->attachAxis(plot.lines[place].ofItsOwn ? others_ : values_);
    other |= plot.lines[place].ofItsOwn;
    line.box = new QCheckBox(plot.lines[place].name, this);
    line.box->setChecked(true);
    line.box->setToolTip(tr("Show this line"));
    line.value = new QLabel(this);
    line.value->setFont(Theme::numberFont(-0.5));
    line.value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    line.value->setMinimumWidth(72);
    legend_->addWidget(line.box, static_cast<int>(place), 0);
    legend_->addWidget(line.value, static_cast<int>(place), 1);
    connect(line.box, &QCheckBox::toggled, line.series, &QLineSeries::setVisible);
    connect(line.box, &QCheckBox::toggled, this, &DiagnosticsPanel::plotNow);
    lines_.push_back(line);
  }
  others_->setVisible(other);
}

void DiagnosticsPanel::plotSoon() {
  if (isVisible() && !timer_.isActive()) timer_.start();
}

void DiagnosticsPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  plotSoon();
}

void DiagnosticsPanel::plotNow() {
  const double from = std::max(axis_.from(), 0.0);
  const double to = std::min(axis_.to(), axis_.end());
  const auto buckets = static_cast<std::size_t>(std::max(chart_->plotArea().width(), 100.0));
  std::vector<QList<QPointF>> points;
  for (std::size_t line = 0; line < lines_.size(); ++line) {
    points.push_back(decimated(feed_.notes(), plots_[plot_].lines[line], from, to, buckets));
  }
  setRange(*time_, from, to, 6.0);
  fitValues(*values_, false, points);
  fitValues(*others_, true, points);
  for (std::size_t line = 0; line < lines_.size(); ++line) lines_[line].series->replace(points[line]);
  showCursor();
}

/// Large numbers are drawn in thousands, millions and so on, so that the labels stay short.
void DiagnosticsPanel::fitValues(QValueAxis& axis, bool ofItsOwn, std::vector<QList<QPointF>>& points) {
  const auto isMeant = [&](std::size_t line) { return plots_[plot_].lines[line].ofItsOwn == ofItsOwn; };
  double least = 0.0;
  double most = 0.0;
  for (std::size_t line = 0; line < points.size(); ++line) {
    if (!isMeant(line) || !lines_[line].box->isChecked()) continue;
    for (const QPointF& point : points[line]) {
      if (!std::isfinite(point.y())) continue;
      least = std::min(least, point.y());
      most = std::max(most, point.y());
    }
  }
  const Thousands thousands = thousandsOf(std::max(most, -least));
  for (std::size_t line = 0; line < points.size(); ++line) {
    if (!isMeant(line)) continue;
    for (QPointF& point : points[line]) point.ry() /= thousands.factor;
  }
  if (!ofItsOwn) {
    unit_->setText(plots_[plot_].unit);
    axis.setTitleText(thousands.prefix.isEmpty() ? QString() : thousands.prefix + u' ' + plots_[plot_].unit);
  }
  least /= thousands.factor;
  most /= thousands.factor;
  if (least == most) most = 1.0;
  const double room = 0.06 * (most - least);
  setRange(axis, least < 0.0 ? least - room : 0.0, most + room, 4.0);
}

std::size_t DiagnosticsPanel::presentFrame() const {
  const std::size_t count = feed_.notes().size();
  if (session_.followsRun()) return count > 0 ? count - 1 : 0;
  return session_.playback().frame();
}

void DiagnosticsPanel::showCursor() {
  if (!isVisible()) return;
  const std::vector<FrameNote>& notes = feed_.notes();
  const std::size_t frame = presentFrame();
  const bool some = frame < notes.size();
  cursor_->setVisible(some);
  for (std::size_t line = 0; line < lines_.size(); ++line)
    lines_[line].value->setText(some ? shortNumber(plots_[plot_].lines[line].value(notes[frame]))
                                     : QString());
  if (!some) return;
  const QRectF area = chart_->plotArea();
  const double x = chart_->mapToPosition({notes[frame].time, 0.0}, lines_[0].series).x();
  cursor_->setLine(x, area.top(), x, area.bottom());
  cursor_->setVisible(x >= area.left() - 1.0 && x <= area.right() + 1.0);
}

bool DiagnosticsPanel::eventFilter(QObject* watched, QEvent* event) {
  const bool press = event->type() == QEvent::MouseButtonPress;
  if (!press && event->type() != QEvent::MouseMove) {
    if (event->type() == QEvent::Resize) plotSoon();
    return QWidget::eventFilter(watched, event);
  }
  const auto* mouse = static_cast<QMouseEvent*>(event);
  if (!mouse->buttons().testFlag(Qt::LeftButton)) return QWidget::eventFilter(watched, event);
  const QPointF at = chart_->mapFromScene(view_->mapToScene(mouse->position().toPoint()));
  session_.playback().stop();
  session_.playback().seekTime(chart_->mapToValue(at, lines_[0].series).x());
  return true;
}

}  // namespace ui
