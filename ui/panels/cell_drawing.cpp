#include "ui/panels/cell_drawing.h"

#include <QPainter>
#include <array>
#include <bit>

#include "ui/theme/theme.h"

namespace ui {
namespace {

/// Corner i of a cube: bits 0, 1, 2 are x, y, z. Seen a little from above and from the side.
QPointF corner(unsigned i) {
  const double x = (i & 1U) ? 0.5 : -0.5;
  const double y = (i & 2U) ? 0.5 : -0.5;
  const double z = (i & 4U) ? 0.5 : -0.5;
  return {0.92 * x + 0.42 * y, -0.86 * z - 0.30 * y + 0.16 * x};
}

bool isEven(unsigned corner) {
  return std::popcount(corner) % 2 == 0;
}

/// Whether the pattern has a bond between two corners that differ along so many axes.
bool joins(modeling::BondPattern pattern, unsigned a, unsigned b) {
  const int axes = std::popcount(a ^ b);
  switch (pattern) {
    case modeling::BondPattern::full:
      return true;
    case modeling::BondPattern::fig1:
      return axes != 2;
    case modeling::BondPattern::fig2:
      return axes == 1 || (axes == 2 && isEven(a));
    case modeling::BondPattern::faces:
      return axes != 3;
  }
  return false;
}

}  // namespace

CellDrawing::CellDrawing(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("cell-drawing"));
  setFixedHeight(sizeHint().height());
  connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void CellDrawing::setPattern(modeling::BondPattern pattern) {
  pattern_ = pattern;
  update();
}

void CellDrawing::paintEvent(QPaintEvent*) {
  const Colours& colours = Theme::instance().colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double size = 0.62 * std::min(width(), height());
  painter.translate(QRectF(rect()).center());
  painter.scale(size, size);
  const auto draw = [&](int axes, const QColor& colour, double width) {
    painter.setPen(QPen(colour, width / size, Qt::SolidLine, Qt::RoundCap));
    for (unsigned a = 0; a < 8; ++a) {
      for (unsigned b = a + 1; b < 8; ++b) {
        if (std::popcount(a ^ b) == axes && joins(pattern_, a, b)) painter.drawLine(corner(a), corner(b));
      }
    }
  };
  draw(3, colours.warning, 1.2);
  draw(2, colours.accent, 1.2);
  draw(1, colours.dimText, 1.8);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colours.text);
  for (unsigned i = 0; i < 8; ++i) painter.drawEllipse(corner(i), 3.2 / size, 3.2 / size);
}

}  // namespace ui
