#pragma once

#include <QLineF>
#include <QList>
#include <QPointF>
#include <QRectF>
#include <QSizeF>
#include <vector>

namespace ui {

/// A line as it lies on the page, and the size of its name.
struct LabelledLine {
  std::vector<QPointF> points;
  QSizeF label;
};

/// Where each line's name goes: beside one of its points, inside `area`, off other names, and off lines as
/// far as there is room.
std::vector<QRectF> placeLabels(const std::vector<LabelledLine>& lines, const QList<QLineF>& obstacles,
                                const QRectF& area);

}  // namespace ui
