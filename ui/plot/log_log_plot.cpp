#include "ui/plot/log_log_plot.h"

#include <QApplication>
#include <QChart>
#include <QDir>
#include <QGraphicsScene>
#include <QGraphicsSimpleTextItem>
#include <QImage>
#include <QLineF>
#include <QLineSeries>
#include <QLogValueAxis>
#include <QPainter>
#include <QScatterSeries>
#include <QSvgGenerator>
#include <algorithm>
#include <cmath>
#include <memory>

#include "ui/plot/label_places.h"

namespace ui {
namespace {

constexpr double kWidth = 520.0;   // px of one plot
constexpr double kHeight = 430.0;  // px
constexpr double kHeading = 52.0;  // px above the plots
constexpr int kPixelsPerUnit = 2;  // of the PNG
const QColor kInk("#1f2430");
const QColor kQuiet("#5b6472");
const QColor kGrid("#e3e6eb");

/// Qt draws text only while an application lives. Plots need no display.
void needApplication() {
  if (QCoreApplication::instance() != nullptr) return;
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) qputenv("QT_QPA_PLATFORM", "offscreen");
  // Qt looks for a folder that has no part in drawing, and complains where there is none.
  if (qEnvironmentVariableIsEmpty("XDG_RUNTIME_DIR")) qputenv("XDG_RUNTIME_DIR", QDir::tempPath().toUtf8());
  static int count = 1;
  static char name[] = "smithereens";
  static char* arguments[] = {name, nullptr};
  static const QApplication application(count, arguments);
}

QFont font(double pixels, QFont::Weight weight = QFont::Normal) {
  QFont font({"Inter", "Noto Sans", "DejaVu Sans", "sans-serif"});
  font.setPixelSize(static_cast<int>(pixels));
  font.setWeight(weight);
  return font;
}

struct Range {
  double low = 1.0;
  double high = 10.0;
};

/// From the data, with a little air on both ends.
Range rangeOf(const LogLogPlot& plot, std::size_t axis) {
  double low = std::numeric_limits<double>::infinity();
  double high = 0.0;
  const auto add = [&](double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  };
  for (const PlotSeries& series : plot.series) {
    for (const auto& point : series.points) add(point[axis]);
  }
  if (axis == 1 && plot.goal) add(*plot.goal);
  if (!(high > 0.0)) return {};
  const double air = axis == 0 ? 2.0 : 1.6;
  return {low / air, high * air};
}

/// 0.01 as it is, 1e-5 as a power.
QString tickText(double value) {
  if (value >= 9.9e-4 && value < 9.9e3) return QString::number(value, 'g', 3);
  const int power = static_cast<int>(std::floor(std::log10(value) + 1e-9));
  const auto times = static_cast<int>(std::lround(value / std::pow(10.0, power)));
  static const QString digits = QString::fromUtf8("⁰¹²³⁴⁵⁶⁷⁸⁹");
  QString text = times == 1 ? QString() : QString::number(times) + QString::fromUtf8("·");
  text += QStringLiteral("10") + (power < 0 ? QString::fromUtf8("⁻") : QString());
  for (const QChar digit : QString::number(std::abs(power))) text += digits[digit.digitValue()];
  return text;
}

/// One plot: Qt Charts makes the area, grid and lines; ticks and names are put where they read best.
class Panel {
 public:
  Panel(const LogLogPlot& plot, QGraphicsScene& page, const QPointF& corner)
      : plot_(plot), page_(page), corner_(corner), x_(rangeOf(plot, 0)), y_(rangeOf(plot, 1)) {
    chart_ = new QChart;
    page.addItem(chart_);
    chart_->setGeometry(QRectF(corner, QSizeF(kWidth, kHeight)));
    chart_->setPlotArea(QRectF(72.0, 34.0, kWidth - 92.0, kHeight - 92.0));
    chart_->legend()->hide();
    chart_->setBackgroundVisible(false);
    addFrame();
    addAxis(Qt::AlignBottom, x_);
    addAxis(Qt::AlignLeft, y_);
    if (plot.goal) addGoal();
    for (const PlotSeries& series : plot.series) addSeries(series);
    addTicks(Qt::Horizontal, x_);
    addTicks(Qt::Vertical, y_);
    addTitles();
    addNames();
  }

 private:
  void addFrame() {
    const QRectF area = chart_->plotArea().translated(corner_);
    addLine({area.bottomLeft(), area.bottomRight()}, kQuiet);
    addLine({area.bottomLeft(), area.topLeft()}, kQuiet);
  }
  void addLine(const QLineF& line, const QColor& colour) {
    page_.addLine(line, QPen(colour, 1.0))->setZValue(colour == kGrid ? -2.0 : -1.0);
  }
  void addAxis(Qt::Alignment side, const Range& range) {
    auto* axis = new QLogValueAxis;
    axis->setBase(10.0);
    axis->setRange(range.low, range.high);
    axis->setVisible(false);
    chart_->addAxis(axis, side);
  }
  void attach(QXYSeries* series) {
    chart_->addSeries(series);
    for (QAbstractAxis* axis : chart_->axes()) series->attachAxis(axis);
  }
  void addGoal() {
    auto* line = new QLineSeries;
    line->setPen(QPen(kQuiet, 1.2, Qt::DashLine));
    line->append(x_.low, *plot_.goal);
    line->append(x_.high, *plot_.goal);
    attach(line);
    const QPointF end = place({x_.low, *plot_.goal});
    addText(QString::fromStdString(plot_.goalName), font(11), kQuiet, end + QPointF(6.0, -17.0));
  }
  void addSeries(const PlotSeries& series) {
    const QColor colour(QString::fromStdString(series.colour));
    auto* line = new QLineSeries;
    line->setPen(QPen(colour, series.strong ? 3.2 : 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    auto* marks = new QScatterSeries;
    marks->setMarkerSize(series.strong ? 9.0 : 7.0);
    marks->setColor(colour);
    marks->setBorderColor(Qt::white);
    for (const auto& point : series.points) {
      line->append(point[0], point[1]);
      marks->append(point[0], point[1]);
    }
    attach(line);
    attach(marks);
  }
  void addTicks(Qt::Orientation orientation, const Range& range) {
    const int first = static_cast<int>(std::ceil(std::log10(range.low)));
    const int last = static_cast<int>(std::floor(std::log10(range.high)));
    const int every = std::max(1, (last - first + 5) / 6);
    for (int power = first; power <= last; power += every) addTick(orientation, std::pow(10.0, power));
    // Short of two decades, powers of ten alone would be a scale of one or two numbers.
    if (last - first >= 2) return;
    for (int power = first - 1; power <= last; ++power) {
      for (const double value : {2.0 * std::pow(10.0, power), 5.0 * std::pow(10.0, power)})
        if (value > range.low && value < range.high) addTick(orientation, value);
    }
  }
  void addTick(Qt::Orientation orientation, double value) {
    const bool level = orientation == Qt::Horizontal;
    const QPointF at = level ? place({value, y_.low}) : place({x_.low, value});
    const QRectF area = chart_->plotArea().translated(corner_);
    addLine(level ? QLineF(at, QPointF(at.x(), area.top())) : QLineF(at, QPointF(area.right(), at.y())),
            kGrid);
    auto* text = addText(tickText(value), font(11.5), kQuiet, at);
    const QSizeF size = text->boundingRect().size();
    text->moveBy(level ? -0.5 * size.width() : -size.width() - 8.0, level ? 6.0 : -0.5 * size.height());
  }
  void addTitles() {
    addText(QString::fromStdString(plot_.title), font(14, QFont::DemiBold), kInk,
            corner_ + QPointF(72.0, 6.0));
    auto* below = addText(QString::fromStdString(plot_.xTitle), font(12.5), kInk, {});
    const QRectF area = chart_->plotArea().translated(corner_);
    below->setPos(area.center().x() - 0.5 * below->boundingRect().width(), area.bottom() + 27.0);
    auto* beside = addText(QString::fromStdString(plot_.yTitle), font(12.5), kInk, {});
    beside->setRotation(-90.0);
    beside->setPos(corner_.x() + 8.0, area.center().y() + 0.5 * beside->boundingRect().width());
  }
  void addNames() {
    std::vector<LabelledLine> lines;
    for (const PlotSeries& series : plot_.series) {
      LabelledLine line;
      for (const auto& point : series.points) line.points.push_back(place(point));
      line.label = textItem(series)->boundingRect().size();
      lines.push_back(std::move(line));
    }
    QList<QLineF> obstacles;
    if (plot_.goal) {
      obstacles.push_back({place({x_.low, *plot_.goal}), place({x_.high, *plot_.goal})});
      const QPointF name = place({x_.low, *plot_.goal}) + QPointF(0.0, -9.0);
      obstacles.push_back({name, name + QPointF(34.0, 0.0)});
    }
    const auto places =
        placeLabels(lines, obstacles, chart_->plotArea().translated(corner_).adjusted(3, 3, -3, -3));
    for (std::size_t i = 0; i < places.size(); ++i) {
      auto* text = textItem(plot_.series[i]).release();
      text->setZValue(10.0);
      text->setPos(places[i].topLeft());
      page_.addItem(text);
    }
  }
  static std::unique_ptr<QGraphicsSimpleTextItem> textItem(const PlotSeries& series) {
    auto item = std::make_unique<QGraphicsSimpleTextItem>(QString::fromStdString(series.name));
    item->setFont(font(12.5, series.strong ? QFont::Bold : QFont::Medium));
    item->setBrush(QColor(QString::fromStdString(series.colour)).darker(112));
    return item;
  }
  QGraphicsSimpleTextItem* addText(const QString& words, const QFont& with, const QColor& colour,
                                   const QPointF& at) {
    auto* text = page_.addSimpleText(words, with);
    text->setBrush(colour);
    text->setPos(at);
    text->setZValue(10.0);
    return text;
  }
  /// Where a value lies on the page. By hand: Qt Charts knows only after its layout has run.
  QPointF place(const std::array<double, 2>& value) const {
    const QRectF area = chart_->plotArea().translated(corner_);
    const auto share = [](double v, const Range& range) {
      return std::log(v / range.low) / std::log(range.high / range.low);
    };
    return {area.left() + share(value[0], x_) * area.width(),
            area.bottom() - share(value[1], y_) * area.height()};
  }

  const LogLogPlot& plot_;
  QGraphicsScene& page_;
  QPointF corner_;
  Range x_;
  Range y_;
  QChart* chart_ = nullptr;
};

bool savePng(QGraphicsScene& page, const QString& file) {
  QImage image(page.sceneRect().size().toSize() * kPixelsPerUnit, QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::TextAntialiasing);
  page.render(&painter);
  painter.end();
  return image.save(file);
}

bool saveSvg(QGraphicsScene& page, const QString& file) {
  QSvgGenerator generator;
  generator.setFileName(file);
  generator.setSize(page.sceneRect().size().toSize());
  generator.setViewBox(page.sceneRect());
  QPainter painter;
  if (!painter.begin(&generator)) return false;
  painter.fillRect(page.sceneRect(), Qt::white);
  page.render(&painter);
  return painter.end();
}

}  // namespace

sim::Status savePlots(const PlotSheet& sheet, const std::filesystem::path& stem) {
  needApplication();
  QGraphicsScene page(0.0, 0.0, kWidth * static_cast<double>(sheet.plots.size()), kHeading + kHeight);
  auto* heading = page.addSimpleText(QString::fromStdString(sheet.title), font(19, QFont::DemiBold));
  heading->setBrush(kInk);
  heading->setPos(22.0, 16.0);
  for (std::size_t i = 0; i < sheet.plots.size(); ++i)
    const Panel panel(sheet.plots[i], page, QPointF(kWidth * static_cast<double>(i), kHeading));
  const QString path = QString::fromStdString(stem.string());
  std::error_code error;
  if (stem.has_parent_path()) std::filesystem::create_directories(stem.parent_path(), error);
  if (!savePng(page, path + ".png") || !saveSvg(page, path + ".svg"))
    return sim::Problem{stem.string(), "the plot cannot be written", "choose another folder"};
  return sim::Done{};
}

}  // namespace ui
