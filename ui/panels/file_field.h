#pragma once

#include <QWidget>

class QToolButton;

namespace ui {

class TextField;

/// The path of a file: to be typed, or chosen by a button.
class FileField : public QWidget {
  Q_OBJECT

 public:
  /// `patterns` are those of the files that can be chosen, such as "*.obj *.ply".
  explicit FileField(const QString& patterns, QWidget* parent = nullptr);
  void setValue(const QString& path);
  /// Where the button starts to look, and what paths are relative to; empty: nowhere yet.
  void setFolder(const QString& folder) { folder_ = folder; }

 signals:
  void edited(const QString& path);

 private:
  void choose();

  QString patterns_;
  QString folder_;
  TextField* text_;
  QToolButton* button_;
};

}  // namespace ui
