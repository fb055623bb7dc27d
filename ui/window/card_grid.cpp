#include "ui/window/card_grid.h"

#include <QPainter>
#include <QPainterPath>
#include <QTextLayout>
#include <algorithm>

#include "ui/theme/theme.h"

namespace ui {
namespace {

constexpr int kGap = 14;
constexpr int kNarrowest = 220;
constexpr int kWidest = 310;
constexpr int kTextHeight = 68;
constexpr qreal kCorner = 6.0;

int pictureHeight(int width) {
  return width * 10 / 16;
}

/// What does not fit into the second line ends in dots.
void drawTwoLines(QPainter& painter, const QRectF& place, const QString& text) {
  QTextLayout layout(text, painter.font());
  layout.beginLayout();
  QTextLine line = layout.createLine();
  line.setLineWidth(place.width());
  const QFontMetricsF metrics(painter.font());
  painter.drawText(QPointF(place.left(), place.top() + metrics.ascent()),
                   text.left(line.textLength()).trimmed());
  const QString rest = text.mid(line.textLength());
  layout.endLayout();
  painter.drawText(QPointF(place.left(), place.top() + metrics.lineSpacing() + metrics.ascent()),
                   metrics.elidedText(rest, Qt::ElideRight, place.width()));
}

}  // namespace

Card::Card(const QString& title, const QString& words, const QImage& picture, QWidget* parent)
    : QAbstractButton(parent), words_(words), picture_(picture) {
  setText(title);
  setToolTip(words);
  setCursor(Qt::PointingHandCursor);
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_Hover);
}

int Card::heightFor(int width) {
  return pictureHeight(width) + kTextHeight;
}

QSize Card::sizeHint() const {
  return {kNarrowest, heightFor(kNarrowest)};
}

void Card::paintEvent(QPaintEvent*) {
  const Colours& colours = Theme::instance().colours();
  QPainter painter(this);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  const QRectF whole = QRectF(rect()).adjusted(1, 1, -1, -1);
  QPainterPath shape;
  shape.addRoundedRect(whole, kCorner, kCorner);
  painter.fillPath(shape, isDown() ? colours.field : colours.panel);
  const QRectF top(whole.left(), whole.top(), whole.width(), pictureHeight(width()));
  painter.save();
  painter.setClipPath(shape);
  painter.setClipRect(top, Qt::IntersectClip);
  if (picture_.isNull()) {
    painter.fillRect(top, colours.field);
    const QRectF place(top.center() - QPointF(20, 20), QSizeF(40, 40));
    Theme::icon(iconName_).paint(&painter, place.toRect(), Qt::AlignCenter, QIcon::Normal, QIcon::On);
  } else {
    const QSizeF size = QSizeF(picture_.size()).scaled(top.size(), Qt::KeepAspectRatioByExpanding);
    painter.drawImage(QRectF(top.center() - QPointF(size.width(), size.height()) / 2, size), picture_);
  }
  painter.restore();
  const bool marked = hasFocus() || underMouse();
  painter.setPen(QPen(marked ? colours.accent : colours.line, marked ? 1.5 : 1.0));
  painter.drawPath(shape);

  const QRectF words = QRectF(whole.left() + 10, top.bottom() + 7, whole.width() - 20, kTextHeight - 16);
  QFont bold = font();
  bold.setWeight(QFont::DemiBold);
  painter.setFont(bold);
  painter.setPen(colours.text);
  painter.drawText(words, Qt::AlignLeft | Qt::AlignTop,
                   QFontMetricsF(bold).elidedText(text(), Qt::ElideRight, words.width()));
  painter.setFont(font());
  painter.setPen(colours.dimText);
  const qreal below = QFontMetricsF(bold).height() + 3.0;
  drawTwoLines(painter, words.adjusted(0.0, below, 0.0, 0.0), words_);
}

CardGrid::CardGrid(QWidget* parent) : QWidget(parent) {
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void CardGrid::add(Card* card) {
  card->setParent(this);
  card->show();
  cards_.push_back(card);
  arrange();
  updateGeometry();
}

void CardGrid::clear() {
  for (Card* card : cards_) card->deleteLater();
  cards_.clear();
  updateGeometry();
}

int CardGrid::columnsFor(int width) const {
  return std::max(1, (width + kGap) / (kNarrowest + kGap));
}

int CardGrid::cardWidth(int width) const {
  const int columns = columnsFor(width);
  return std::min(kWidest, (width - (columns - 1) * kGap) / columns);
}

int CardGrid::heightForWidth(int width) const {
  const int rows = (static_cast<int>(cards_.size()) + columnsFor(width) - 1) / columnsFor(width);
  return rows == 0 ? 0 : rows * (Card::heightFor(cardWidth(width)) + kGap) - kGap;
}

QSize CardGrid::sizeHint() const {
  const int width = std::max(this->width(), kNarrowest);
  return {width, heightForWidth(width)};
}

void CardGrid::resizeEvent(QResizeEvent*) {
  arrange();
}

void CardGrid::arrange() {
  const int columns = columnsFor(width());
  const int wide = cardWidth(width());
  for (std::size_t i = 0; i < cards_.size(); ++i) {
    const int column = static_cast<int>(i) % columns;
    const int row = static_cast<int>(i) / columns;
    cards_[i]->setGeometry(column * (wide + kGap), row * (Card::heightFor(wide) + kGap), wide,
                           Card::heightFor(wide));
  }
  setMinimumHeight(heightForWidth(width()));
}

}  // namespace ui
