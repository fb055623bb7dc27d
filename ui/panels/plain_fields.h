#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QToolButton>

#include "ui/document/pending_edit.h"

/// Fields of a panel that are not numbers, with signals alike: what the person does, never what the program
/// sets.
namespace ui {

/// A line of text that counts when Enter is pressed or the field is left; Esc takes it back.
class TextField : public QLineEdit, public PendingEdit {
  Q_OBJECT

 public:
  explicit TextField(QWidget* parent = nullptr);
  void setValue(const QString& text);
  void rehearse() override;

 signals:
  void edited(const QString& text);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  bool event(QEvent* event) override;

 private:
  void take();
  QString value_;
  bool rehearsing_ = false;
};

/// A box to be ticked, in a form.
class CheckField : public QCheckBox {
  Q_OBJECT

 public:
  using QCheckBox::QCheckBox;
  QSize minimumSizeHint() const override;
};

/// One of several; the wheel passes over it unless it has the focus.
class ChoiceField : public QComboBox {
  Q_OBJECT

 public:
  explicit ChoiceField(QWidget* parent = nullptr);
  /// What is chosen, by its data; -1 or unknown data: nothing.
  void setValue(const QVariant& chosen);

 signals:
  void edited(const QVariant& chosen);

 protected:
  void wheelEvent(QWheelEvent* event) override;
};

/// A swatch that opens a colour chooser. What is tried there counts at once, as one edit. A colour that is
/// not valid stands for none, which is shown in words.
class ColourField : public QToolButton {
  Q_OBJECT

 public:
  explicit ColourField(QWidget* parent = nullptr);
  void setAbsentText(const QString& text) { absentText_ = text; }
  QColor value() const { return value_; }
  void setValue(const QColor& colour);
  QSize sizeHint() const override;

 signals:
  void edited(const QColor& colour, bool finished);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void choose();
  QColor value_;
  QString absentText_;
};

}  // namespace ui
