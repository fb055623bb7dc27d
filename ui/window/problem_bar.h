#pragma once

#include <QFrame>

#include "sim/base/result.h"

class QLabel;

namespace ui {

/// What went wrong and how to mend it, above the viewport until it is mended or put away.
class ProblemBar : public QFrame {
  Q_OBJECT

 public:
  explicit ProblemBar(QWidget* parent = nullptr);
  /// In place of one that is shown; `place` is the problem's, in words.
  void show(const sim::Problem& problem, const QString& place);
  void putAway() { hide(); }
  const QString& text() const { return text_; }

 private:
  void dress();

  QLabel* icon_;
  QLabel* label_;
  QString text_;
};

}  // namespace ui
