#pragma once

#include <QWidget>

class QToolButton;
class QVBoxLayout;

namespace ui {

/// A group of a panel with a title that folds it away. What a person folded or opened stays so, here and
/// wherever else a section has the same name.
class Section : public QWidget {
  Q_OBJECT

 public:
  /// `open` counts until a person folds or opens it.
  Section(const QString& title, bool open, QWidget* parent);

  void add(QWidget* content);
  bool isOpen() const;
  void setOpen(bool open);

 private:
  void showArrow();

  QString key_;
  bool open_;
  QToolButton* head_;
  QWidget* body_;
  QVBoxLayout* rows_;
};

}  // namespace ui
