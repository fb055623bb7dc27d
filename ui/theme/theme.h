#pragma once

#include <QColor>
#include <QFont>
#include <QIcon>
#include <QObject>

class QApplication;

namespace ui {

enum class ThemeKind { dark, light };

/// The colours everything is drawn in. All text has a contrast of at least 4.5 to 1 on what it stands on,
/// dimmed text 3 to 1.
struct Colours {
  QColor window;  ///< behind panels, and bars
  QColor panel;   ///< lists, forms
  QColor field;   ///< what can be typed into
  QColor raised;  ///< buttons
  QColor line;    ///< between things
  QColor text;
  QColor dimText;     ///< units, hints, what is off
  QColor accent;      ///< what is selected or active
  QColor accentText;  ///< on accent
  QColor good;
  QColor warning;
  QColor bad;
  QColor viewTop;  ///< of the viewport's background
  QColor viewBottom;
  QColor grid;
  QColor gridStrong;
  QColor axisX;
  QColor axisY;
  QColor axisZ;
};

/// Look of the whole program: palette, style sheet, fonts and icons, which all follow when it changes.
class Theme : public QObject {
  Q_OBJECT

 public:
  /// The one there is. Before apply() it is dark.
  static Theme& instance();

  ThemeKind kind() const { return kind_; }
  const Colours& colours() const;
  void apply(ThemeKind kind);

  /// resources/icons/NAME.svg in the present theme's colours, sharp at every size; changes with the theme by
  /// itself. The icons are drawn in black, which stands for the colour of text.
  static QIcon icon(const QString& name);
  /// For numbers: all digits as wide as each other.
  static QFont numberFont(double pointSizeChange = 0.0);

 signals:
  void changed();

 private:
  Theme() = default;
  ThemeKind kind_ = ThemeKind::dark;
};

}  // namespace ui
