#include "ui/plot/label_places.h"

#include <algorithm>
#include <array>
#include <limits>

namespace ui {
namespace {

constexpr double kGap = 7.0;  // px between a point and a name
/// A name on a name can't be read, one outside is cut; one across a line is only ugly.
constexpr double kCollision = 1e4;
constexpr int kSamples = 60;  // of each stretch of a line, to see whether it runs through a name

std::array<QRectF, 8> around(const QPointF& point, const QSizeF& size) {
  const double w = size.width(), h = size.height(), x = point.x(), y = point.y();
  return {QRectF(QPointF(x + kGap, y - h / 2), size),
          QRectF(QPointF(x + kGap / 2, y - h - kGap / 2), size),
          QRectF(QPointF(x + kGap / 2, y + kGap / 2), size),
          QRectF(QPointF(x - w / 2, y - h - kGap), size),
          QRectF(QPointF(x - w / 2, y + kGap), size),
          QRectF(QPointF(x - w - kGap / 2, y + kGap / 2), size),
          QRectF(QPointF(x - w - kGap, y - h / 2), size),
          QRectF(QPointF(x - w - kGap / 2, y - h - kGap / 2), size)};
}

int crossings(const QRectF& rectangle, const QLineF& stretch) {
  int inside = 0;
  for (int s = 0; s <= kSamples; ++s)
    inside += rectangle.contains(stretch.pointAt(static_cast<double>(s) / kSamples)) ? 1 : 0;
  return inside;
}

}  // namespace

std::vector<QRectF> placeLabels(const std::vector<LabelledLine>& lines, const QList<QLineF>& obstacles,
                                const QRectF& area) {
  QList<QLineF> stretches = obstacles;
  for (const LabelledLine& line : lines) {
    for (std::size_t i = 1; i < line.points.size(); ++i)
      stretches.push_back({line.points[i - 1], line.points[i]});
  }
  std::vector<QRectF> places;
  for (const LabelledLine& line : lines) {
    QRectF best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < line.points.size(); ++i) {
      const auto candidates = around(line.points[i], line.label);
      for (std::size_t c = 0; c < candidates.size(); ++c) {
        const QRectF& rectangle = candidates[c];
        // Names at the ends of lines, to the right, are found first.
        double cost =
            0.1 * static_cast<double>(c) + 0.3 * static_cast<double>(std::min(i, line.points.size() - 1 - i));
        if (!area.contains(rectangle)) cost += kCollision;
        for (const QRectF& taken : places) cost += taken.intersects(rectangle) ? kCollision : 0.0;
        for (const QLineF& stretch : stretches) cost += crossings(rectangle.adjusted(-2, -2, 2, 2), stretch);
        if (cost < least) {
          least = cost;
          best = rectangle;
        }
      }
    }
    places.push_back(best);
  }
  return places;
}

}  // namespace ui
