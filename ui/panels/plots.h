#pragma once

#include <QColor>
#include <QList>
#include <QPointF>
#include <QString>
#include <functional>
#include <vector>

#include "ui/session/footage.h"

/// What the diagnostics draw over time.
namespace ui {

struct PlotLine {
  QString name;
  std::function<double(const FrameNote&)> value;
  bool ofItsOwn = false;  ///< on an axis of its own, to the right
};

struct Plot {
  QString name;
  QString unit;
  std::vector<PlotLine> lines;
};

std::vector<Plot> allPlots();

/// Colours that are told apart by those who are colour-blind too, and on dark and light alike; the last of
/// seven is the text's.
QColor plotColour(std::size_t line);

/// The line between two times, no finer than `buckets` stretches of it; of each its lowest and its highest
/// value are kept, so that no peak is lost.
QList<QPointF> decimated(const std::vector<FrameNote>& notes, const PlotLine& line, double from, double to,
                         std::size_t buckets);

/// Three digits and a prefix: "12.3 M".
QString shortNumber(double value);

}  // namespace ui
