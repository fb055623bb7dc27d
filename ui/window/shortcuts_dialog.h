#pragma once

#include <QDialog>

class QMainWindow;
class QVBoxLayout;

namespace ui {

/// All keys, gathered from the window's actions by menu, and what the pointer does in the viewport.
class ShortcutsDialog : public QDialog {
  Q_OBJECT

 public:
  explicit ShortcutsDialog(QMainWindow& window);
};

}  // namespace ui
