#include "ui/panels/item_icons.h"

#include <QPainter>
#include <QPixmap>

#include "ui/kinds/collider_kinds.h"
#include "ui/kinds/part_kinds.h"
#include "ui/theme/theme.h"

namespace ui {
namespace {

QColor colourOf(const modeling::Colour& colour) {
  return QColor::fromRgbF(static_cast<float>(colour[0]), static_cast<float>(colour[1]),
                          static_cast<float>(colour[2]));
}

}  // namespace

QIcon swatchOf(const modeling::Look& look) {
  // Drawn large: it is scaled down, and looks right on fine screens too.
  constexpr int kSize = 64;
  QPixmap pixels(kSize, kSize);
  pixels.fill(Qt::transparent);
  QPainter painter(&pixels);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF disc(7, 7, kSize - 14, kSize - 14);
  QRadialGradient light(QPointF(24, 20), 44);
  const QColor outside = colourOf(look.outside);
  light.setColorAt(0.0, outside.lighter(100 + static_cast<int>(40.0 * look.glaze)));
  light.setColorAt(0.4, outside);
  light.setColorAt(1.0, outside.darker(150));
  painter.setPen(QPen(Theme::instance().colours().dimText, 2.5));
  painter.setBrush(light);
  painter.drawEllipse(disc);
  painter.end();
  QIcon icon;
  for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Selected}) icon.addPixmap(pixels, mode);
  return icon;
}

QIcon iconOf(const modeling::Scene& scene, const Item& item) {
  if (item.index >= countOf(scene, item.kind)) return {};
  switch (item.kind) {
    case ItemKind::scene:
      return Theme::icon(QStringLiteral("scene"));
    case ItemKind::part:
      return Theme::icon(kindOf(scene.parts[item.index].shape).icon);
    case ItemKind::gluing:
      return Theme::icon(QStringLiteral("glue"));
    case ItemKind::collider:
      return Theme::icon(kindOf(scene.environment.colliders[item.index].form).icon);
    case ItemKind::material:
      return swatchOf(scene.materials[item.index].values.look);
    case ItemKind::track:
      return Theme::icon(QStringLiteral("track"));
  }
  return {};
}

QIcon quietIcon(const char* name, bool quiet) {
  const QIcon icon = Theme::icon(QString::fromLatin1(name));
  if (!quiet) return icon;
  QIcon faint;
  faint.addPixmap(icon.pixmap(QSize(32, 32), 1.0, QIcon::Disabled), QIcon::Normal);
  faint.addPixmap(icon.pixmap(QSize(32, 32), 1.0, QIcon::Selected), QIcon::Selected);
  return faint;
}

}  // namespace ui
