#pragma once

#include <QWidget>

#include "sim/base/types.h"

namespace ui {

/// Where something points, as seen from above: in the middle straight down, at the rim level. Dragged by its
/// dot; a double click points it down again.
class DirectionPad : public QWidget {
  Q_OBJECT

 public:
  explicit DirectionPad(QWidget* parent = nullptr);

  QSize sizeHint() const override { return {88, 88}; }
  const sim::Vec3& direction() const { return direction_; }
  /// Of any length but 0; what points up is shown by where its opposite points.
  void setDirection(const sim::Vec3& direction);

 signals:
  /// By a person: unit.
  void changed(const sim::Vec3& direction);
  void released();

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  double radius() const;
  void pointAt(const QPointF& at);
  void choose(const sim::Vec3& direction);

  sim::Vec3 direction_ = -sim::Vec3::UnitZ();
};

}  // namespace ui
