#include <QPainter>
#include <QPainterPath>

#include "ui/theme/theme.h"
#include "ui/viewport/collider_shape.h"
#include "ui/viewport/colour_map.h"
#include "ui/viewport/painted_overlay.h"
#include "ui/viewport/viewport.h"
#include "ui/viewport/viewport_renderer.h"

namespace ui {
namespace {

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

void Viewport::paintLegend(QPainter& painter) const {
  int row = 0;
  const ViewSettings& settings = drawn_->settings;
  if (!drawn_->motion) return;
  if (settings.bonds)
    paintLegendCard(painter, viewSize(), row++, tr("Strain / threshold"), tr("0"), tr("1: breaks"));
  if (settings.surface && settings.colouring == Colouring::quality)
    paintLegendCard(painter, viewSize(), row++, tr("Scaled Jacobian"), tr("0: flat"), tr("1: cube"));
}

void Viewport::paintStatistics(QPainter& painter) const {
  if (!viewSettings_.statistics) return;
  const DrawStatistics& drawing = renderer_->statistics();
  const sim::Network* network = drawn_->shown.network.get();
  const QStringList lines{
      tr("%L1 nodes, %L2 bonds")
          .arg(network ? network->nodeCount() : 0)
          .arg(network ? network->bondCount() : 0),
      tr("%L1 faces").arg(drawn_->topology ? drawn_->topology->faces.size() : 0),
      tr("%L1 draw calls").arg(drawing.drawCalls),
      tr("%L1 kB uploaded").arg(static_cast<double>(drawing.uploadedBytes) / 1000.0, 0, 'f', 1),
      tr("%L1 ms to prepare").arg(drawn_->milliseconds, 0, 'f', 2),
      tr("%L1 ms to paint").arg(drawing.paintMilliseconds, 0, 'f', 2),
      tr("%L1 ms longest wait of the window").arg(heartbeat_.longestWait(), 0, 'f', 0)};
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

void Viewport::paintInvisible(Overlay& overlay) const {
  if (!viewSettings_.invisibleColliders) return;
  for (const sim::Collider& collider : drawn_->colliders) {
    if (collider.visible) continue;
    for (const auto& [from, to] : sim::outlineOf(collider))
      overlay.line(from, to, Theme::instance().colours().dimText, 1.0);
  }
}

void Viewport::paintOver() {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  PaintedOverlay overlay(painter, camera_, viewSize());
  paintInvisible(overlay);
  for (const auto& paint : overlays_) paint(overlay);
  if (tool_) tool_->draw(*this, overlay);
  axisGizmo_.paint(painter, camera_, viewSize(), pointer_);
  paintLegend(painter);
  paintStatistics(painter);
  paintBand(painter);
}

}  // namespace ui
