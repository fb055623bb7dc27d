#pragma once

#include <QWidget>

class QAction;
class QComboBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QMenu;
class QProgressBar;
class QSpinBox;
class QToolButton;

namespace ui {

class PlayActions;
class Session;

/// The row of buttons and fields above the timeline.
class Transport : public QWidget {
  Q_OBJECT

 public:
  Transport(Session& session, PlayActions& actions, QWidget* parent = nullptr);

  /// At its right end, such as what opens the tracks.
  void addButton(QAction* action, QMenu* menu = nullptr);

 private:
  void makeButtons(QHBoxLayout& row);
  void makeFields(QHBoxLayout& row);
  void makeSpeed(QHBoxLayout& row);
  void makeProgress(QHBoxLayout& row);
  QToolButton* button(QHBoxLayout& row, QAction* action);
  void showMoment();
  void showRun();

  Session& session_;
  PlayActions& actions_;
  QHBoxLayout* end_ = nullptr;
  QDoubleSpinBox* time_ = nullptr;
  QSpinBox* frame_ = nullptr;
  QLabel* frameCount_ = nullptr;
  QComboBox* speed_ = nullptr;
  QToolButton* follow_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QLabel* left_ = nullptr;
};

/// "12 s left", "3 min left"; empty where it is not known.
QString timeLeft(double seconds);

}  // namespace ui
