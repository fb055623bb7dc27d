#pragma once

#include <QFrame>

class QToolButton;

namespace ui {

class ViewActions;
class Viewport;

/// The tools, in the upper left corner of a viewport, and what it shows, in the upper right one, with a menu
/// of the rest.
class ViewBars : public QObject {
  Q_OBJECT

 public:
  ViewBars(Viewport& viewport, const ViewActions& actions);

 protected:
  bool eventFilter(QObject* object, QEvent* event) override;

 private:
  QToolButton* addButton(QFrame& bar, QAction* action);
  void place();
  void showChoices();

  Viewport& viewport_;
  QFrame* tools_ = nullptr;
  QFrame* shows_ = nullptr;
  QToolButton* more_ = nullptr;
};

}  // namespace ui
