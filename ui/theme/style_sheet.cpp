#include "ui/theme/style_sheet.h"

#include <utility>

namespace ui {
namespace {

constexpr const char* kTemplate = R"(
QToolTip { color: @text; background: @panel; border: 1px solid @line; padding: 4px 6px; }
QMainWindow::separator { background: @window; width: 4px; height: 4px; }
QMainWindow::separator:hover { background: @accent; }
QDockWidget { titlebar-close-icon: none; titlebar-normal-icon: none; }
QDockWidget::title { background: @window; padding: 6px 8px; }
QMenuBar { background: @window; padding: 1px; }
QMenuBar::item { padding: 4px 9px; border-radius: 3px; background: transparent; }
QMenuBar::item:selected { background: @raised; }
QMenu { background: @panel; border: 1px solid @line; padding: 4px; }
QMenu::item { padding: 5px 28px 5px 12px; border-radius: 3px; }
QMenu::icon { padding-left: 8px; }
QMenu::item:selected { background: @accent; color: @accentText; }
QMenu::item:disabled { color: @dimText; }
QMenu::separator { height: 1px; background: @line; margin: 4px 6px; }
QToolBar { background: @window; border: 0; spacing: 2px; padding: 3px 6px; }
QToolBar::separator { background: @line; width: 1px; margin: 4px 5px; }
QToolButton { background: transparent; border: 1px solid transparent; border-radius: 4px; padding: 4px; }
QToolButton:hover { background: @raised; }
QToolButton:pressed, QToolButton:checked { background: @field; border-color: @line; }
QToolButton:focus { border-color: @accent; }
#viewBar { background: @panel; border: 1px solid @line; border-radius: 6px; }
#viewBar QToolButton:checked { background: @raised; border-color: @accent; }
#viewChoices { background: @panel; border: 1px solid @line; }
QPushButton { background: @raised; border: 1px solid @line; border-radius: 4px; padding: 5px 12px; }
QPushButton:hover { border-color: @dimText; }
QPushButton:pressed, QPushButton:checked { background: @field; }
QPushButton:default { border-color: @accent; }
QPushButton:focus { border-color: @accent; }
QDialogButtonBox, QMessageBox { dialogbuttonbox-buttons-have-icons: 0; }
QPushButton::menu-indicator { width: 0; }
QPushButton:disabled { color: @dimText; background: @panel; }
QLineEdit, QPlainTextEdit, QTextEdit, QAbstractSpinBox {
  background: @field; border: 1px solid @line; border-radius: 4px; padding: 3px 6px;
  selection-background-color: @accent; selection-color: @accentText; }
QComboBox { combobox-popup: 0; background: @field; border: 1px solid @line; border-radius: 4px; padding: 3px 6px; }
QComboBox:focus { border-color: @accent; }
QComboBox::drop-down { border: 0; width: 20px; }
QComboBox::down-arrow { image: url(:/icons/arrow-of-choice.svg); width: 10px; height: 10px; }
QLineEdit:focus, QPlainTextEdit:focus, QTextEdit:focus, QAbstractSpinBox:focus { border-color: @accent; }
QAbstractItemView { background: @panel; border: 1px solid transparent; outline: 0; alternate-background-color: @panel; }
QAbstractItemView:focus { border-color: @accent; }
QAbstractItemView::item { padding: 3px 4px; }
QAbstractItemView::item:selected { background: @accent; color: @accentText; }
QComboBox QAbstractItemView { selection-background-color: @accent; selection-color: @accentText; }
QComboBox QAbstractItemView::item:hover { background: @accent; color: @accentText; }
QHeaderView::section { background: @window; border: 0; border-bottom: 1px solid @line; padding: 4px 6px; }
QTabWidget::pane { border: 0; }
QTabBar { background: @window; }
QTabBar::tab { background: transparent; color: @dimText; padding: 6px 12px; border: 0;
  border-bottom: 2px solid transparent; }
QTabBar::tab:selected { color: @text; border-bottom-color: @accent; }
QTabBar::tab:hover { color: @text; }
QTabBar::tab:selected:focus { background: @raised; }
QGroupBox { border: 0; border-top: 1px solid @line; margin-top: 16px; padding-top: 6px; font-weight: 600; }
QGroupBox::title { subcontrol-origin: margin; left: 0; padding: 0 6px 0 0; }
QScrollArea { border: 0; background: @panel; }
QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 10px; margin: 0; }
QScrollBar::handle { background: @line; border-radius: 4px; min-width: 24px; min-height: 24px; margin: 1px; }
QScrollBar::handle:hover { background: @dimText; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QSlider::groove:horizontal { height: 4px; background: @line; border-radius: 2px; }
QSlider::sub-page:horizontal { background: @accent; border-radius: 2px; }
QSlider::handle:horizontal { background: @text; width: 14px; margin: -5px 0; border-radius: 7px; }
QSlider::handle:horizontal:hover, QSlider::handle:horizontal:focus { background: @accent; }
QProgressBar { background: @field; border: 1px solid @line; border-radius: 4px; text-align: center; height: 14px; }
QProgressBar::chunk { background: @accent; border-radius: 3px; }
QStatusBar { background: @window; color: @dimText; }
QStatusBar::item { border: 0; }
QSplitter::handle { background: @window; }
)";

}  // namespace

QString styleSheetOf(const Colours& colours) {
  QString sheet = QString::fromLatin1(kTemplate);
  // Longer names first: one may begin with another.
  const std::pair<const char*, QColor> names[] = {
      {"@accentText", colours.accentText}, {"@accent", colours.accent}, {"@dimText", colours.dimText},
      {"@window", colours.window},         {"@raised", colours.raised}, {"@panel", colours.panel},
      {"@field", colours.field},           {"@line", colours.line},     {"@text", colours.text}};
  for (const auto& [name, colour] : names) sheet.replace(QLatin1String(name), colour.name());
  return sheet;
}

}  // namespace ui
