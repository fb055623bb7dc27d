#pragma once

#include <QMainWindow>

#include "ui/session/session.h"

class QDockWidget;
class QLabel;
class QMenu;
class QProgressBar;
class QToolBar;

namespace ui {

class PlayActions;
class Viewport;

/// The window: menus, bars, docks around the viewport. What it shows and does is the session's.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(Session& session, QWidget* parent = nullptr);

  Session& session() { return session_; }
  Viewport& viewport() { return *viewport_; }

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  // Made once, in this order (main_window_layout.cpp).
  void makeCentre();
  void makeDocks();
  void makeMenus();
  void makeToolBar();
  void makeStatusBar();
  QDockWidget* addDock(const QString& name, const QString& title, QWidget* content, Qt::DockWidgetArea area);

  void showTitle();
  void showRun();
  void showProblem(const sim::Problem& problem);

  Session& session_;
  Viewport* viewport_ = nullptr;
  PlayActions* playActions_ = nullptr;
  QLabel* hint_ = nullptr;
  QLabel* state_ = nullptr;
  QProgressBar* progress_ = nullptr;
};

}  // namespace ui
