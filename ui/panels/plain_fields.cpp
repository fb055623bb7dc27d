#include "ui/panels/plain_fields.h"

#include <QColorDialog>
#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>

#include "ui/theme/theme.h"

namespace ui {

TextField::TextField(QWidget* parent) : QLineEdit(parent) {
  setStyleSheet(
      QStringLiteral("QLineEdit:read-only { background: transparent; border-color: transparent; }"));
  connect(this, &QLineEdit::editingFinished, this, &TextField::take);
}

void TextField::setValue(const QString& text) {
  if (rehearsing_) return;
  const bool typing = hasFocus() && isModified();
  value_ = text;
  if (typing || text == this->text()) return;
  setText(text);
  setCursorPosition(0);
}

void TextField::take() {
  if (!isModified()) return;
  setModified(false);
  const QString typed = text();
  if (typed == value_) return;
  emit edited(typed);
  // What was refused goes back to what holds.
  if (!isModified() && text() != value_) setText(value_);
}

void TextField::rehearse() {
  if (!isModified() || text() == value_) return;
  rehearsing_ = true;
  emit edited(text());
  rehearsing_ = false;
  setModified(true);
}

void TextField::keyPressEvent(QKeyEvent* event) {
  if (event->key() != Qt::Key_Escape) return QLineEdit::keyPressEvent(event);
  setText(value_);
  setModified(false);
  selectAll();
}

bool TextField::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();
    return true;
  }
  return QLineEdit::event(event);
}

ChoiceField::ChoiceField(QWidget* parent) : QComboBox(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(6);
  connect(this, &QComboBox::activated, this, [this] { emit edited(currentData()); });
}

void ChoiceField::setValue(const QVariant& chosen) {
  setCurrentIndex(chosen.isValid() ? findData(chosen) : -1);
}

void ChoiceField::wheelEvent(QWheelEvent* event) {
  if (hasFocus()) return QComboBox::wheelEvent(event);
  event->ignore();
}

QSize CheckField::minimumSizeHint() const {
  // A long name does not keep the panel from being narrow.
  return {60, QCheckBox::minimumSizeHint().height()};
}

ColourField::ColourField(QWidget* parent) : QToolButton(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(this, &QToolButton::clicked, this, &ColourField::choose);
}

void ColourField::setValue(const QColor& colour) {
  if (colour == value_) return;
  value_ = colour;
  update();
}

QSize ColourField::sizeHint() const {
  return {60, QFontMetrics(Theme::numberFont()).height() + 8};
}

void ColourField::choose() {
  const QColor before = value_;
  // It goes with the field, where what the colour is of goes.
  auto* dialog = new QColorDialog(before.isValid() ? before : QColor(Qt::gray), this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(toolTip().isEmpty() ? tr("Colour") : toolTip());
  connect(dialog, &QColorDialog::currentColorChanged, this, [this](const QColor& colour) {
    setValue(colour);
    emit edited(colour, false);
  });
  connect(dialog, &QDialog::finished, this, [this, dialog, before](int result) {
    setValue(result == QDialog::Accepted ? dialog->currentColor() : before);
    emit edited(value_, true);
  });
  dialog->open();
}

void ColourField::paintEvent(QPaintEvent*) {
  const Colours& colours = Theme::instance().colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(hasFocus() ? colours.accent : underMouse() ? colours.dimText : colours.line);
  painter.setBrush(value_.isValid() ? value_ : colours.field);
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4.0, 4.0);
  if (value_.isValid()) return;
  painter.setPen(colours.dimText);
  painter.drawText(rect().adjusted(8, 0, -8, 0), Qt::AlignRight | Qt::AlignVCenter, absentText_);
}

}  // namespace ui
