#pragma once

#include <QWidget>

#include "ui/editors/glue_editing.h"

class QLabel;
class QPushButton;
class QSlider;
class QToolButton;

namespace ui {

class NumberField;

/// What there is to see and set of a gluing, over the corner of the viewport while the glue tool is used.
class GluePanel : public QWidget {
  Q_OBJECT

 public:
  GluePanel(GlueEditing& editing, QWidget* parent);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QWidget* makeReach();
  QWidget* makeButtons();
  void follow();
  QString countsText() const;
  QString problemText() const;
  void placeInCorner();

  GlueEditing& editing_;
  QLabel* title_ = nullptr;
  QLabel* step_ = nullptr;
  QWidget* adjust_ = nullptr;
  QSlider* slider_ = nullptr;
  NumberField* reach_ = nullptr;
  QLabel* counts_ = nullptr;
  QLabel* problem_ = nullptr;
  QPushButton* useNearest_ = nullptr;
  QPushButton* everywhere_ = nullptr;
  QToolButton* swap_ = nullptr;
  QPushButton* glue_ = nullptr;
  QPushButton* remove_ = nullptr;
  QPushButton* close_ = nullptr;
};

}  // namespace ui
