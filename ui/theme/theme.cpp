#include "ui/theme/theme.h"

#include <QApplication>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleOption>

#include "ui/theme/icon_engine.h"
#include "ui/theme/style_sheet.h"

namespace ui {
namespace {

Colours darkColours() {
  Colours colours;
  colours.window = QColor(0x1f, 0x22, 0x26);
  colours.panel = QColor(0x27, 0x2a, 0x2f);
  colours.field = QColor(0x1a, 0x1c, 0x20);
  colours.raised = QColor(0x35, 0x39, 0x40);
  colours.line = QColor(0x3b, 0x40, 0x47);
  colours.text = QColor(0xe4, 0xe6, 0xe9);
  colours.dimText = QColor(0x98, 0xa0, 0xab);
  colours.accent = QColor(0x4d, 0x9d, 0xe0);
  colours.accentText = QColor(0x0b, 0x13, 0x1c);
  colours.good = QColor(0x6f, 0xc2, 0x8b);
  colours.warning = QColor(0xe5, 0xb4, 0x54);
  colours.bad = QColor(0xf0, 0x7b, 0x6c);
  colours.viewTop = QColor(0x3a, 0x3f, 0x46);
  colours.viewBottom = QColor(0x22, 0x25, 0x2a);
  colours.grid = QColor(0x4a, 0x50, 0x58);
  colours.gridStrong = QColor(0x60, 0x67, 0x71);
  colours.axisX = QColor(0xe0, 0x6c, 0x5e);
  colours.axisY = QColor(0x7d, 0xbf, 0x6a);
  colours.axisZ = QColor(0x5d, 0xa0, 0xe8);
  return colours;
}

Colours lightColours() {
  Colours colours;
  colours.window = QColor(0xe9, 0xeb, 0xee);
  colours.panel = QColor(0xf7, 0xf8, 0xf9);
  colours.field = QColor(0xff, 0xff, 0xff);
  colours.raised = QColor(0xfd, 0xfd, 0xfe);
  colours.line = QColor(0xc9, 0xce, 0xd4);
  colours.text = QColor(0x1d, 0x21, 0x26);
  colours.dimText = QColor(0x60, 0x69, 0x74);
  colours.accent = QColor(0x1b, 0x6e, 0xb8);
  colours.accentText = QColor(0xff, 0xff, 0xff);
  colours.good = QColor(0x22, 0x7a, 0x45);
  colours.warning = QColor(0x8f, 0x5f, 0x00);
  colours.bad = QColor(0xb8, 0x33, 0x24);
  colours.viewTop = QColor(0xf2, 0xf4, 0xf6);
  colours.viewBottom = QColor(0xcf, 0xd5, 0xdb);
  colours.grid = QColor(0xb4, 0xbb, 0xc3);
  colours.gridStrong = QColor(0x8f, 0x98, 0xa3);
  colours.axisX = QColor(0xc2, 0x3b, 0x2c);
  colours.axisY = QColor(0x3d, 0x87, 0x29);
  colours.axisZ = QColor(0x21, 0x68, 0xb8);
  return colours;
}

QPalette paletteOf(const Colours& colours) {
  QPalette palette;
  palette.setColor(QPalette::Window, colours.window);
  palette.setColor(QPalette::WindowText, colours.text);
  palette.setColor(QPalette::Base, colours.field);
  palette.setColor(QPalette::AlternateBase, colours.panel);
  palette.setColor(QPalette::Text, colours.text);
  palette.setColor(QPalette::PlaceholderText, colours.dimText);
  palette.setColor(QPalette::Button, colours.raised);
  palette.setColor(QPalette::ButtonText, colours.text);
  palette.setColor(QPalette::BrightText, colours.bad);
  palette.setColor(QPalette::ToolTipBase, colours.panel);
  palette.setColor(QPalette::ToolTipText, colours.text);
  palette.setColor(QPalette::Highlight, colours.accent);
  palette.setColor(QPalette::HighlightedText, colours.accentText);
  palette.setColor(QPalette::Link, colours.accent);
  palette.setColor(QPalette::LinkVisited, colours.accent);
  palette.setColor(QPalette::Light, colours.raised.lighter(115));
  palette.setColor(QPalette::Midlight, colours.raised);
  palette.setColor(QPalette::Mid, colours.line);
  palette.setColor(QPalette::Dark, colours.line.darker(120));
  palette.setColor(QPalette::Shadow, colours.window.darker(160));
  for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, colours.dimText);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, colours.line);
  palette.setColor(QPalette::Disabled, QPalette::HighlightedText, colours.dimText);
  return palette;
}

/// Fusion, with the program's own signs in questions and warnings: those of Fusion are coloured pixels of
/// another family.
class Style : public QProxyStyle {
 public:
  Style() : QProxyStyle(QStringLiteral("Fusion")) {}

  /// Boxes to be ticked are seen empty too, and have the accent's colour when they are not.
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    if (element != PE_IndicatorCheckBox) return QProxyStyle::drawPrimitive(element, option, painter, widget);
    const Colours& colours = Theme::instance().colours();
    const bool on = option->state.testFlag(State_On);
    const bool enabled = option->state.testFlag(State_Enabled);
    const QRectF box = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    // On the accent's own colour the accent is not seen.
    painter->setPen(option->state.testFlag(State_HasFocus)    ? (on ? colours.text : colours.accent)
                    : option->state.testFlag(State_MouseOver) ? colours.dimText
                                                              : colours.line);
    painter->setBrush(!on ? colours.field : enabled ? colours.accent : colours.line);
    painter->drawRoundedRect(box, 3.0, 3.0);
    if (on) {
      const auto at = [&](double x, double y) {
        return box.topLeft() + QPointF(x * box.width(), y * box.height());
      };
      painter->setPen(QPen(enabled ? colours.accentText : colours.dimText, 1.8, Qt::SolidLine, Qt::RoundCap,
                           Qt::RoundJoin));
      painter->setBrush(Qt::NoBrush);
      painter->drawPolyline(QPolygonF{at(0.23, 0.51), at(0.43, 0.71), at(0.79, 0.31)});
    }
    painter->restore();
  }

  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override {
    constexpr int kBox = 15;  // logical pixels
    if (metric == PM_IndicatorWidth || metric == PM_IndicatorHeight) return kBox;
    return QProxyStyle::pixelMetric(metric, option, widget);
  }

  QIcon standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const override {
    switch (which) {
      case SP_MessageBoxQuestion:
        return Theme::icon(QStringLiteral("question"));
      case SP_MessageBoxInformation:
        return Theme::icon(QStringLiteral("information"));
      case SP_MessageBoxWarning:
      case SP_MessageBoxCritical:
        return Theme::icon(QStringLiteral("warning"));
      default:
        return QProxyStyle::standardIcon(which, option, widget);
    }
  }
};

}  // namespace

Theme& Theme::instance() {
  static Theme theme;
  return theme;
}

const Colours& Theme::colours() const {
  static const Colours dark = darkColours();
  static const Colours light = lightColours();
  return kind_ == ThemeKind::dark ? dark : light;
}

void Theme::apply(ThemeKind kind) {
  kind_ = kind;
  QApplication::setStyle(new Style);
  QFont font(QStringLiteral("Inter"));
  font.setPointSizeF(9.5);
  QApplication::setFont(font);
  QApplication::setPalette(paletteOf(colours()));
  qApp->setStyleSheet(styleSheetOf(colours()));
  emit changed();
}

QIcon Theme::icon(const QString& name) {
  return QIcon(new IconEngine(name));
}

QFont Theme::numberFont(double pointSizeChange) {
  QFont font(QStringLiteral("JetBrains Mono"));
  font.setStyleHint(QFont::Monospace);
  font.setPointSizeF(QApplication::font().pointSizeF() + pointSizeChange);
  return font;
}

}  // namespace ui
