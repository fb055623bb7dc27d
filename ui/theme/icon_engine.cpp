#include "ui/theme/icon_engine.h"

#include <QFile>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>

#include "ui/theme/theme.h"

namespace ui {
namespace {

QColor colourOf(const QString& name, QIcon::Mode mode, QIcon::State state) {
  const Colours& colours = Theme::instance().colours();
  if (mode == QIcon::Disabled) {
    QColor faint = colours.dimText;
    faint.setAlphaF(0.5F);
    return faint;
  }
  if (mode == QIcon::Selected) return colours.accentText;
  if (state == QIcon::Off) return colours.text;
  // The lamp of what records is red everywhere.
  return name == QLatin1String("record") ? colours.bad : colours.accent;
}

}  // namespace

void IconEngine::paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) {
  const qreal ratio = painter->device()->devicePixelRatioF();
  QPixmap pixels = pixmap((QSizeF(rect.size()) * ratio).toSize(), mode, state);
  painter->drawPixmap(rect, pixels);
}

QPixmap IconEngine::pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) {
  const QColor colour = colourOf(name_, mode, state);
  const QString key = QStringLiteral("icon/%1/%2x%3/%4")
                          .arg(name_)
                          .arg(size.width())
                          .arg(size.height())
                          .arg(colour.name(QColor::HexArgb));
  QPixmap pixels;
  if (QPixmapCache::find(key, &pixels)) return pixels;
  pixels = QPixmap(size);
  pixels.fill(Qt::transparent);
  QPainter painter(&pixels);
  QSvgRenderer renderer(QStringLiteral(":/icons/%1.svg").arg(name_));
  renderer.render(&painter, QRectF(QPointF(0, 0), size));
  // The drawing says where, the theme in which colour.
  painter.setCompositionMode(QPainter::CompositionMode_SourceIn);
  painter.fillRect(pixels.rect(), colour);
  painter.end();
  QPixmapCache::insert(key, pixels);
  return pixels;
}

}  // namespace ui
