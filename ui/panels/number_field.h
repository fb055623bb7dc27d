#pragma once

#include <QWidget>
#include <optional>

#include "ui/document/pending_edit.h"
#include "ui/panels/quantity.h"

class QLineEdit;

namespace ui {

/// What a number field shows and takes.
struct NumberFormat {
  Dimension dimension = Dimension::number;
  double least = -1e300;
  double most = 1e300;
  double step = 0.1;         ///< base units: what the wheel and the arrow keys add, and what Ctrl snaps to
  bool logarithmic = false;  ///< dragging multiplies instead: for values that span many powers of ten
  bool gauge = false;        ///< a bar shows how far it is between its bounds
  bool whole = false;
  bool unitShown = true;  ///< off where the label says it
  QString autoText;       ///< not empty: the value may be absent, which is shown as this word
};

/// A number with its unit that can be dragged to the left and right (Shift: finer, Ctrl: in steps), clicked
/// and typed with arithmetic and units, stepped by wheel and arrow keys, and reset by a double click. Esc
/// takes back what is under way; Tab takes it and goes on.
class NumberField : public QWidget, public PendingEdit {
  Q_OBJECT

 public:
  explicit NumberField(const NumberFormat& format, QWidget* parent = nullptr);

  const NumberFormat& format() const { return format_; }
  std::optional<double> value() const { return value_; }
  /// Shows it; announces nothing. Leaves alone what is being typed.
  void setValue(std::optional<double> value);
  /// What a double click resets to.
  void setDefault(std::optional<double> value) { default_ = value; }
  /// Shown beside the word for "absent", and where dragging starts from there.
  void setAutoValue(std::optional<double> value);
  /// Several things are shown that differ.
  void setMixed(bool mixed);
  /// Marks the field; "" takes the mark away.
  void setProblem(bool problem);
  /// A stripe on the left, for the axes of a vector.
  void setStripe(const QColor& colour);

  bool isEditing() const;
  void beginEditing();
  void rehearse() override;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 signals:
  /// The person changed it. Successive changes belong together until one is `finished`.
  void edited(std::optional<double> value, bool finished);

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void timerEvent(QTimerEvent* event) override;

 private:
  double fitted(double value) const;
  void change(std::optional<double> value, bool finished);
  void dragTo(double pixels, Qt::KeyboardModifiers modifiers);
  void stepBy(double steps);
  void settleSteps();
  void cancelDrag();
  bool meansAbsent(const QString& text) const;
  /// What is typed, where the field may have it.
  Reading readText() const;
  /// False: the text means nothing, and the person was told why.
  bool takeText();
  void endEditing();
  void showError(const Reading& reading);
  QString rangeText() const;
  void paintContent(QPainter& painter) const;

  NumberFormat format_;
  std::optional<double> value_;
  std::optional<double> default_;
  std::optional<double> autoValue_;
  bool mixed_ = false;
  bool problem_ = false;
  bool wrongText_ = false;
  QColor stripe_;
  QLineEdit* editor_ = nullptr;  ///< null: not typing
  QString typedFrom_;            ///< the text when typing began

  std::optional<QPointF> pressedAt_;
  bool dragging_ = false;
  std::optional<double> valueAtPress_;
  int stepTimer_ = 0;  ///< runs while steps by wheel or keys may still belong together
};

}  // namespace ui
