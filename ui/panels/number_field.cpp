#include "ui/panels/number_field.h"

#include <QApplication>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <cmath>

#include "ui/theme/theme.h"

namespace ui {
namespace {

/// Logical pixels: dragging begins, a step is dragged, a power of ten is dragged.
constexpr double kDragThreshold = 3.0;
constexpr double kPixelsPerStep = 6.0;
constexpr double kPixelsPerDecade = 160.0;
constexpr double kFiner = 0.1;
/// Steps that follow each other faster than this are one edit.
constexpr int kStepPause = 500;
constexpr int kMargin = 7;
constexpr double kCorner = 4.0;

}  // namespace

NumberField::NumberField(const NumberFormat& format, QWidget* parent) : QWidget(parent), format_(format) {
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::SizeHorCursor);
  setAttribute(Qt::WA_Hover);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  connect(&Theme::instance(), &Theme::changed, this, qOverload<>(&QWidget::update));
}

void NumberField::setValue(std::optional<double> value) {
  if (dragging_ || (value == value_ && !mixed_)) return;
  value_ = value;
  mixed_ = false;
  update();
}

void NumberField::setAutoValue(std::optional<double> value) {
  if (value == autoValue_) return;
  autoValue_ = value;
  update();
}

void NumberField::setMixed(bool mixed) {
  if (mixed == mixed_ || dragging_) return;
  mixed_ = mixed;
  update();
}

void NumberField::setProblem(bool problem) {
  if (problem == problem_) return;
  problem_ = problem;
  update();
}

void NumberField::setStripe(const QColor& colour) {
  if (colour == stripe_) return;
  stripe_ = colour;
  update();
}

QSize NumberField::sizeHint() const {
  const QFontMetrics metrics(Theme::numberFont());
  return {metrics.horizontalAdvance(u'0') * 12 + 2 * kMargin, metrics.height() + 8};
}

QSize NumberField::minimumSizeHint() const {
  const QFontMetrics metrics(Theme::numberFont());
  return {metrics.horizontalAdvance(u'0') * 5 + 2 * kMargin, metrics.height() + 8};
}

double NumberField::fitted(double value) const {
  if (format_.whole) value = std::round(value);
  return std::clamp(value, format_.least, format_.most);
}

void NumberField::change(std::optional<double> value, bool finished) {
  value_ = value;
  mixed_ = false;
  update();
  emit edited(value, finished);
}

// Dragging.

void NumberField::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::RightButton && dragging_) return cancelDrag();
  if (event->button() != Qt::LeftButton) return;
  settleSteps();
  pressedAt_ = event->position();
  valueAtPress_ = value_;
  setFocus(Qt::MouseFocusReason);
}

void NumberField::mouseMoveEvent(QMouseEvent* event) {
  if (!pressedAt_) return;
  const double pixels = event->position().x() - pressedAt_->x();
  if (!dragging_ && std::abs(pixels) < kDragThreshold) return;
  dragging_ = true;
  dragTo(pixels, event->modifiers());
}

void NumberField::dragTo(double pixels, Qt::KeyboardModifiers modifiers) {
  const double speed = modifiers.testFlag(Qt::ShiftModifier) ? kFiner : 1.0;
  const double start = valueAtPress_.value_or(autoValue_.value_or(default_.value_or(0.0)));
  double value = start + speed * pixels / kPixelsPerStep * format_.step;
  if (format_.logarithmic && start != 0.0) value = start * std::pow(10.0, speed * pixels / kPixelsPerDecade);
  if (modifiers.testFlag(Qt::ControlModifier)) {
    double step = format_.step * speed;
    if (format_.logarithmic && value != 0.0) step = std::pow(10.0, std::floor(std::log10(std::abs(value))));
    value = std::round(value / step) * step;
  } else if (!format_.logarithmic) {
    // Digits that nobody aimed at: a hundredth of a step is finer than a hand.
    const double grain = format_.step * 0.01;
    value = std::round(value / grain) * grain;
  } else if (value != 0.0) {
    const double grain = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2.0);
    value = std::round(value / grain) * grain;
  }
  value = fitted(value);
  if (value_ != value) change(value, false);
}

void NumberField::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !pressedAt_) return;
  pressedAt_.reset();
  if (!dragging_) return beginEditing();
  dragging_ = false;
  change(value_, true);
}

void NumberField::cancelDrag() {
  pressedAt_.reset();
  if (!dragging_) return;
  dragging_ = false;
  change(valueAtPress_, true);
}

void NumberField::mouseDoubleClickEvent(QMouseEvent* event) {
  // The first of the two clicks has opened the editor, which passes the second on (eventFilter).
  if (event->button() != Qt::LeftButton) return;
  pressedAt_.reset();
  endEditing();
  if (default_ || !format_.autoText.isEmpty()) change(default_, true);
}

// Steps.

void NumberField::wheelEvent(QWheelEvent* event) {
  // Without focus the panel scrolls: a wheel that passes over a field must not change it.
  if (!hasFocus() || isEditing()) return event->ignore();
  const double steps = event->angleDelta().y() / 120.0;
  stepBy(event->modifiers().testFlag(Qt::ShiftModifier) ? steps * kFiner : steps);
  event->accept();
}

void NumberField::stepBy(double steps) {
  const double start = value_.value_or(autoValue_.value_or(default_.value_or(0.0)));
  const bool multiply = format_.logarithmic && start != 0.0;
  const double stepped = multiply ? start * std::pow(10.0, 0.1 * steps) : start + steps * format_.step;
  const double value =
      fitted(format_.whole && std::abs(steps) < 1.0 ? start + std::copysign(1.0, steps) : stepped);
  if (stepTimer_ != 0) killTimer(stepTimer_);
  stepTimer_ = startTimer(kStepPause);
  if (value != value_) change(value, false);
}

void NumberField::timerEvent(QTimerEvent* event) {
  if (event->timerId() == stepTimer_) settleSteps();
}

void NumberField::settleSteps() {
  if (stepTimer_ == 0) return;
  killTimer(stepTimer_);
  stepTimer_ = 0;
  emit edited(value_, true);
}

bool NumberField::event(QEvent* event) {
  // Keys that are shortcuts elsewhere are numbers here.
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    const bool plain = (key->modifiers() & ~(Qt::ShiftModifier | Qt::KeypadModifier)) == Qt::NoModifier;
    const QString text = key->text();
    const bool number = !text.isEmpty() && (text[0].isDigit() || QStringLiteral("+-.,(").contains(text[0]));
    const bool cancels = key->key() == Qt::Key_Escape && dragging_;
    if (plain && (number || cancels || key->key() == Qt::Key_Return)) event->accept();
  }
  return QWidget::event(event);
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  const double finer = event->modifiers().testFlag(Qt::ShiftModifier) ? kFiner : 1.0;
  if (event->key() == Qt::Key_Escape && pressedAt_) return cancelDrag();
  if (event->key() == Qt::Key_Up) return stepBy(finer);
  if (event->key() == Qt::Key_Down) return stepBy(-finer);
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter || event->key() == Qt::Key_F2)
    return beginEditing();
  const QString text = event->text();
  if (!text.isEmpty() && (text[0].isDigit() || QStringLiteral("+-.,(").contains(text[0]))) {
    beginEditing();
    editor_->setText(text);
    return;
  }
  if ((event->key() == Qt::Key_Backspace || event->key() == Qt::Key_Delete) &&
      (default_ || !format_.autoText.isEmpty()))
    return change(default_, true);
  QWidget::keyPressEvent(event);
}

// Typing.

bool NumberField::isEditing() const {
  return editor_ != nullptr;
}

void NumberField::beginEditing() {
  if (editor_ || !isEnabled()) return;
  settleSteps();
  editor_ = new QLineEdit(this);
  editor_->setObjectName(QStringLiteral("number-editor"));
  editor_->setFont(Theme::numberFont());
  editor_->setFocusPolicy(Qt::ClickFocus);
  editor_->setGeometry(rect());
  editor_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  editor_->installEventFilter(this);
  constexpr int kAllDigits = 12;
  if (value_ && !mixed_) {
    const Unit& unit = unitFor(format_.dimension, *value_);
    const QString symbol = QString::fromUtf8(unit.symbol);
    typedFrom_ = numberText(*value_, unit, kAllDigits);
    if (!symbol.isEmpty() && format_.unitShown) typedFrom_ += u' ' + symbol;
  } else {
    typedFrom_ = mixed_ ? QString() : format_.autoText;
  }
  editor_->setText(typedFrom_);
  connect(editor_, &QLineEdit::textEdited, this, [this] {
    wrongText_ = false;
    QToolTip::hideText();
    editor_->setStyleSheet({});
  });
  editor_->show();
  editor_->setFocus();
  editor_->selectAll();
  setCursor(Qt::IBeamCursor);
}

bool NumberField::meansAbsent(const QString& text) const {
  if (format_.autoText.isEmpty()) return false;
  return text.isEmpty() || text.compare(format_.autoText, Qt::CaseInsensitive) == 0;
}

Reading NumberField::readText() const {
  const Unit& assumed =
      unitFor(format_.dimension, value_.value_or(autoValue_.value_or(default_.value_or(0.0))));
  Reading reading = readQuantity(editor_->text(), format_.dimension, assumed);
  if (reading.value &&
      fitted(*reading.value) != (format_.whole ? std::round(*reading.value) : *reading.value)) {
    reading.value.reset();
    reading.errorAt = 0;
    reading.error = rangeText();
  }
  return reading;
}

bool NumberField::takeText() {
  const QString text = editor_->text().trimmed();
  if (text == typedFrom_) return true;
  if (meansAbsent(text)) {
    change(std::nullopt, true);
    return true;
  }
  const Reading reading = readText();
  if (!reading.value) {
    showError(reading);
    return false;
  }
  change(fitted(*reading.value), true);
  return true;
}

void NumberField::rehearse() {
  if (!editor_ || editor_->text().trimmed() == typedFrom_) return;
  const std::optional<double> before = value_;
  if (meansAbsent(editor_->text().trimmed())) {
    value_.reset();
  } else {
    const Reading reading = readText();
    if (!reading.value) return;
    value_ = fitted(*reading.value);
  }
  emit edited(value_, true);
  value_ = before;
}

QString NumberField::rangeText() const {
  const QString least = quantityText(format_.least, format_.dimension);
  const QString most = quantityText(format_.most, format_.dimension);
  const bool bounded = format_.most < 1e300;
  if (format_.least > -1e300)
    return bounded ? tr("this must be from %1 to %2").arg(least, most)
                   : tr("this must be at least %1").arg(least);
  return tr("this must be at most %1").arg(most);
}

void NumberField::showError(const Reading& reading) {
  wrongText_ = true;
  const QColor bad = Theme::instance().colours().bad;
  editor_->setStyleSheet(QStringLiteral("QLineEdit { border-color: %1; }").arg(bad.name()));
  editor_->setCursorPosition(static_cast<int>(reading.errorAt));
  QString sentence = reading.error;
  if (!sentence.isEmpty()) sentence[0] = sentence[0].toUpper();
  QToolTip::showText(mapToGlobal(QPoint(0, height())), sentence, this, {}, 6000);
}

void NumberField::endEditing() {
  if (!editor_) return;
  QLineEdit* editor = editor_;
  editor_ = nullptr;
  wrongText_ = false;
  editor->removeEventFilter(this);
  // Hiding what has the focus would hand it on to the next field.
  if (editor->hasFocus()) setFocus(Qt::OtherFocusReason);
  editor->hide();
  editor->deleteLater();
  setCursor(Qt::SizeHorCursor);
  update();
}

bool NumberField::eventFilter(QObject* watched, QEvent* event) {
  if (!editor_ || watched != editor_) return QWidget::eventFilter(watched, event);
  if (event->type() == QEvent::MouseButtonDblClick && editor_->text() == typedFrom_) {
    mouseDoubleClickEvent(static_cast<QMouseEvent*>(event));
    setFocus();
    return true;
  }
  if (event->type() == QEvent::FocusOut) {
    if (static_cast<QFocusEvent*>(event)->reason() == Qt::PopupFocusReason) return false;
    // Where the text means nothing the old value stays: nobody can be kept in a field.
    takeText();
    endEditing();
    return false;
  }
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();
    return true;
  }
  if (event->type() != QEvent::KeyPress) return false;
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (key == Qt::Key_Escape) {
    endEditing();
    QToolTip::hideText();
    setFocus();
    return true;
  }
  const bool goesOn = key == Qt::Key_Tab || key == Qt::Key_Backtab;
  if (!goesOn && key != Qt::Key_Return && key != Qt::Key_Enter) return false;
  if (!takeText()) return true;
  endEditing();
  setFocus(Qt::OtherFocusReason);
  if (goesOn) focusNextPrevChild(key == Qt::Key_Tab);
  return true;
}

void NumberField::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  if (event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason) beginEditing();
  update();
}

void NumberField::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  settleSteps();
  update();
}

void NumberField::resizeEvent(QResizeEvent*) {
  if (editor_) editor_->setGeometry(rect());
}

// Looks.

void NumberField::paintEvent(QPaintEvent*) {
  const Colours& colours = Theme::instance().colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF frame = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
  QColor border = colours.line;
  if (underMouse() && isEnabled()) border = colours.dimText;
  if (hasFocus() || dragging_) border = colours.accent;
  if (problem_) border = colours.bad;
  painter.setPen(border);
  painter.setBrush(isEnabled() ? colours.field : colours.panel);
  painter.drawRoundedRect(frame, kCorner, kCorner);
  if (format_.gauge && value_ && !mixed_) {
    const double share = std::clamp((*value_ - format_.least) / (format_.most - format_.least), 0.0, 1.0);
    QColor fill = colours.accent;
    fill.setAlphaF(0.22F);
    painter.setPen(Qt::NoPen);
    painter.setBrush(fill);
    painter.setClipRect(QRectF(0, 0, share * width(), height()));
    painter.drawRoundedRect(frame.adjusted(1, 1, -1, -1), kCorner - 1, kCorner - 1);
    painter.setClipping(false);
  }
  if (stripe_.isValid()) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(stripe_);
    painter.drawRoundedRect(QRectF(3.0, 5.0, 2.0, height() - 10.0), 1.0, 1.0);
  }
  paintContent(painter);
}

void NumberField::paintContent(QPainter& painter) const {
  const Colours& colours = Theme::instance().colours();
  const QFont numberFont = Theme::numberFont();
  const QColor strong = isEnabled() ? colours.text : colours.dimText;
  QRect space = rect().adjusted(kMargin, 0, -kMargin, 0);
  painter.setFont(numberFont);
  if (mixed_ || (!value_ && !autoValue_)) {
    painter.setPen(colours.dimText);
    painter.drawText(space, Qt::AlignRight | Qt::AlignVCenter, mixed_ ? tr("differ") : format_.autoText);
    return;
  }
  const double shown = value_.value_or(autoValue_.value_or(0.0));
  const Unit& unit = unitFor(format_.dimension, shown);
  const QString symbol = format_.unitShown ? QString::fromUtf8(unit.symbol) : QString();
  if (!symbol.isEmpty()) {
    painter.setFont(font());
    painter.setPen(colours.dimText);
    painter.drawText(space, Qt::AlignRight | Qt::AlignVCenter, symbol);
    space.setRight(space.right() - QFontMetrics(font()).horizontalAdvance(symbol) - (symbol == u"°" ? 1 : 4));
    painter.setFont(numberFont);
  }
  const QFontMetrics metrics(numberFont);
  QString text = numberText(shown, unit);
  for (int digits = 5; digits > 1 && metrics.horizontalAdvance(text) > space.width(); --digits)
    text = numberText(shown, unit, digits);
  painter.setPen(value_ ? strong : colours.dimText);
  painter.drawText(space, Qt::AlignRight | Qt::AlignVCenter, text);
  if (value_) return;
  space.setRight(space.right() - metrics.horizontalAdvance(text) - 6);
  painter.setFont(font());
  painter.drawText(space, Qt::AlignLeft | Qt::AlignVCenter, format_.autoText);
}

}  // namespace ui
