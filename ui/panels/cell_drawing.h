#pragma once

#include <QWidget>

#include "modeling/material/material.h"

namespace ui {

/// A cell of a lattice with the bonds of a pattern: edges strong, diagonals of faces and of the body in
/// colours.
class CellDrawing : public QWidget {
 public:
  explicit CellDrawing(QWidget* parent = nullptr);
  void setPattern(modeling::BondPattern pattern);
  QSize sizeHint() const override { return {120, 96}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  modeling::BondPattern pattern_ = modeling::BondPattern::full;
};

}  // namespace ui
