#include "ui/panels/plots.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/theme/theme.h"

namespace ui {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("Plots", text);
}

PlotLine energyLine(const char* name, double sim::Energy::*part) {
  return {tr(name), [part](const FrameNote& note) { return note.ledger.energy.*part; }};
}

Plot energyPlot() {
  Plot plot{tr("Energy"), tr("erg"), {}};
  plot.lines.push_back(energyLine("kinetic", &sim::Energy::kinetic));
  plot.lines.push_back(energyLine("elastic", &sim::Energy::elastic));
  plot.lines.push_back(energyLine("gravity", &sim::Energy::gravity));
  plot.lines.push_back(energyLine("contact", &sim::Energy::contact));
  plot.lines.push_back(energyLine("dissipated", &sim::Energy::dissipated));
  plot.lines.push_back(energyLine("released", &sim::Energy::released));
  plot.lines.push_back({tr("total"), [](const FrameNote& note) {
                          const sim::Energy& energy = note.ledger.energy;
                          return energy.mechanical() + energy.dissipated + energy.released;
                        }});
  return plot;
}

}  // namespace

std::vector<Plot> allPlots() {
  std::vector<Plot> plots = {energyPlot()};
  plots.push_back({tr("Breaking"),
                   {},
                   {{tr("broken bonds"), [](const FrameNote& note) { return double(note.brokenBonds); }},
                    {tr("fragments"), [](const FrameNote& note) { return double(note.fragments); }, true}}});
  plots.push_back({tr("Step"), tr("\u00b5s"), {{tr("step"), [](const FrameNote& note) {
                                                  return 1e6 * note.ledger.step;
                                                }}}});
  plots.push_back({tr("Speed"), tr("\u00d7"), {{tr("real-time factor"), [](const FrameNote& note) {
                                                  return note.realTimeFactor;
                                                }}}});
  plots.push_back(
      {tr("Work"),
       tr("a frame"),
       {{tr("bonds evaluated"), [](const FrameNote& note) { return double(note.bondsEvaluated); }},
        {tr("bonds skipped"), [](const FrameNote& note) { return double(note.bondsSkipped); }}}});
  return plots;
}

QColor plotColour(std::size_t line) {
  static const std::array<QColor, 6> colours = {QColor(0x3d, 0x8f, 0xd9), QColor(0xdb, 0x92, 0x22),
                                                QColor(0x2e, 0xa2, 0x7d), QColor(0xa8, 0x74, 0xd6),
                                                QColor(0xd2, 0x5f, 0x4c), QColor(0xd4, 0x72, 0xa6)};
  return line < colours.size() ? colours[line] : Theme::instance().colours().text;
}

QList<QPointF> decimated(const std::vector<FrameNote>& notes, const PlotLine& line, double from, double to,
                         std::size_t buckets) {
  const auto earlier = [](const FrameNote& note, double time) { return note.time < time; };
  auto first = std::lower_bound(notes.begin(), notes.end(), from, earlier);
  auto last = std::lower_bound(first, notes.end(), to, earlier);
  // A line comes from outside and goes out again.
  if (first != notes.begin()) --first;
  if (last != notes.end()) ++last;
  QList<QPointF> points;
  const auto count = static_cast<std::size_t>(last - first);
  if (count <= 2 * buckets) {
    for (auto note = first; note != last; ++note) points.append({note->time, line.value(*note)});
    return points;
  }
  for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
    QPointF lowest(0.0, std::numeric_limits<double>::infinity());
    QPointF highest(0.0, -std::numeric_limits<double>::infinity());
    for (std::size_t i = bucket * count / buckets; i < (bucket + 1) * count / buckets; ++i) {
      const FrameNote& note = *(first + static_cast<std::ptrdiff_t>(i));
      const QPointF point(note.time, line.value(note));
      if (point.y() < lowest.y()) lowest = point;
      if (point.y() > highest.y()) highest = point;
    }
    points.append(lowest.x() < highest.x() ? lowest : highest);
    if (lowest.x() != highest.x()) points.append(lowest.x() < highest.x() ? highest : lowest);
  }
  return points;
}

QString shortNumber(double value) {
  const double size = std::abs(value);
  const std::pair<double, const char*> prefixes[] = {{1e12, " T"}, {1e9, " G"}, {1e6, " M"}, {1e3, " k"}};
  for (const auto& [factor, prefix] : prefixes) {
    if (size >= factor)
      return QString::number(value / factor, 'f',
                             size >= 100 * factor  ? 0
                             : size >= 10 * factor ? 1
                                                   : 2) +
             QLatin1String(prefix);
  }
  return QString::number(value, 'g', 3);
}

}  // namespace ui
