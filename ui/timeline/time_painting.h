#pragma once

#include <QColor>
#include <QPainter>

namespace ui {

class TimeAxis;

/// Where the stretch of time begins, in all rows of the timeline: names stand to the left of it.
inline constexpr int kTimelineHeader = 176;

/// Lines that are one device pixel sharp, at every scale of the screen.
void verticalLine(QPainter& painter, double x, double top, double bottom, const QColor& colour,
                  double width = 1.0);
void horizontalLine(QPainter& painter, double left, double right, double y, const QColor& colour);

/// A mix of two colours; share 0 is the first.
QColor mixed(const QColor& from, const QColor& to, double share);

}  // namespace ui
