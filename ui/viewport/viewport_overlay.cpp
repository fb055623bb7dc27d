#include "ui/viewport/viewport_overlay.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>

#include "ui/theme/theme.h"
#include "ui/viewport/collider_shape.h"
#include "ui/viewport/colour_map.h"
#include "ui/viewport/overlay.h"

namespace ui {
namespace {

QString words(const char* text) {
  return QCoreApplication::translate("ui::Viewport", text);
}

constexpr double kMargin = 14.0;
constexpr QSizeF kScale(180.0, 10.0);

void paintCard(QPainter& painter, const QRectF& box) {
  QColor behind = Theme::instance().colours().window;
  behind.setAlphaF(0.78F);
  painter.setPen(Qt::NoPen);
  painter.setBrush(behind);
  painter.drawRoundedRect(box, 6.0, 6.0);
  painter.setBrush(Qt::NoBrush);
}

void paintScale(QPainter& painter, const QRectF& box) {
  QLinearGradient gradient(box.topLeft(), box.topRight());
  for (int i = 0; i <= 16; ++i) {
    const Rgb colour = viridis(static_cast<float>(i) / 16.0F);
    gradient.setColorAt(i / 16.0, QColor::fromRgbF(colour[0], colour[1], colour[2]));
  }
  QPainterPath path;
  path.addRoundedRect(box, 3.0, 3.0);
  painter.fillPath(path, gradient);
}

/// A title, a scale and what its ends mean; `row` counts from below.
void paintLegendCard(QPainter& painter, const QSizeF& size, int row, const QString& title, const QString& low,
                     const QString& high) {
  const double line = QFontMetricsF(painter.font()).height();
  const double height = 2.0 * line + kScale.height() + 22.0;
  const QRectF card(size.width() - kMargin - kScale.width() - 24.0,
                    size.height() - kMargin - (row + 1) * (height + 8.0) + 8.0, kScale.width() + 24.0,
                    height);
  paintCard(painter, card);
  const Colours& colours = Theme::instance().colours();
  painter.setPen(colours.text);
  painter.drawText(QRectF(card.left() + 12.0, card.top() + 6.0, kScale.width(), line), Qt::AlignLeft, title);
  const QRectF scale(QPointF(card.left() + 12.0, card.top() + line + 11.0), kScale);
  paintScale(painter, scale);
  painter.setPen(colours.text);
  const QRectF ends(scale.left(), scale.bottom() + 3.0, scale.width(), line);
  painter.drawText(ends, Qt::AlignLeft, low);
  painter.drawText(ends, Qt::AlignRight, high);
}

}  // namespace

void paintLegends(QPainter& painter, const QSizeF& size, const DrawData& data) {
  int row = 0;
  const ViewSettings& settings = data.settings;
  if (!data.motion) return;
  if (settings.bonds)
    paintLegendCard(painter, size, row++, words("Strain / threshold"), words("0"), words("1: breaks"));
  if (settings.surface && settings.colouring == Colouring::quality)
    paintLegendCard(painter, size, row++, words("Scaled Jacobian"), words("0: flat"), words("1: cube"));
}

void paintStatistics(QPainter& painter, const DrawData& data, const DrawStatistics& drawing,
                     double longestWait) {
  const sim::Network* network = data.shown.network.get();
  const QStringList lines{
      words("%L1 nodes, %L2 bonds")
          .arg(network ? network->nodeCount() : 0)
          .arg(network ? network->bondCount() : 0),
      words("%L1 faces").arg(data.topology ? data.topology->faces.size() : 0),
      words("%L1 draw calls").arg(drawing.drawCalls),
      words("%L1 kB uploaded").arg(static_cast<double>(drawing.uploadedBytes) / 1000.0, 0, 'f', 1),
      words("%L1 ms to prepare").arg(data.milliseconds, 0, 'f', 2),
      words("%L1 ms to paint").arg(drawing.paintMilliseconds, 0, 'f', 2),
      words("%L1 ms longest wait of the window").arg(longestWait, 0, 'f', 0)};
  painter.setFont(Theme::numberFont(-1.0));
  const QFontMetricsF metrics(painter.font());
  double width = 0.0;
  for (const QString& line : lines) width = std::max(width, metrics.horizontalAdvance(line));
  const QRectF card(kMargin + 46.0, kMargin + 46.0, width + 24.0,
                    metrics.height() * static_cast<double>(lines.size()) + 14.0);
  paintCard(painter, card);
  painter.setPen(Theme::instance().colours().text);
  for (qsizetype i = 0; i < lines.size(); ++i) {
    painter.drawText(QPointF(card.left() + 12.0,
                             card.top() + 7.0 + metrics.ascent() + static_cast<double>(i) * metrics.height()),
                     lines[i]);
  }
}

void paintInvisibleColliders(Overlay& overlay, const DrawData& data) {
  for (const sim::Collider& collider : data.colliders) {
    if (collider.visible) continue;
    for (const auto& [from, to] : sim::outlineOf(collider))
      overlay.line(from, to, Theme::instance().colours().dimText, 1.0);
  }
}

void paintBand(QPainter& painter, const QRectF& band) {
  if (band.isEmpty()) return;
  QColor colour = Theme::instance().colours().accent;
  painter.setPen(QPen(colour, 1.0));
  colour.setAlphaF(0.15F);
  painter.setBrush(colour);
  painter.drawRect(band);
  painter.setBrush(Qt::NoBrush);
}

}  // namespace ui
