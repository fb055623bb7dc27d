#pragma once

#include <QMainWindow>
#include <filesystem>

#include "ui/files/file_actions.h"
#include "ui/files/recent_files.h"
#include "ui/session/session.h"

class QDockWidget;
class QLabel;
class QMenu;
class QStackedWidget;
class QToolBar;

namespace ui {

class AddActions;
class EditorActions;
class Gallery;
class PlayActions;
class PreflightDialog;
class ProblemBar;
class SceneActions;
class Viewport;

/// The window: menus, bars, docks around the viewport. What it shows and does is the session's.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(Session& session, QWidget* parent = nullptr);
  ~MainWindow() override;

  Session& session() { return session_; }
  Viewport& viewport() { return *viewport_; }
  FileActions& files() { return *files_; }

  /// Asks whether to take up what programs that were killed left in `root`.
  void offerLeftovers(const std::filesystem::path& root);
  /// The gallery in the viewport's place; the scene stays open behind it.
  void showGallery();
  void showViewport();

 protected:
  void closeEvent(QCloseEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  // Made once, in this order (main_window_layout.cpp, main_window_menus.cpp).
  void makeCentre();
  void makeDocks();
  void makeEditors();
  void makeMenus();
  void makeFileMenu();
  void makeEditMenu();
  void makeViewMenu();
  void makeNavigationMenu();
  void makeSimulateMenu();
  void makeHelpMenu();
  void makeToolBar();
  void makeStatusBar();
  QDockWidget* addDock(const QString& name, const QString& title, QWidget* content, Qt::DockWidgetArea area);
  void rememberLayout() const;
  void recallLayout();
  void useFirstLayout();
  void toggleProfile(QDockWidget& profile);

  void showTitle();
  void showRun();
  void showPreviewProblem();
  void showProblem(const sim::Problem& problem);
  void keepPicture();
  void takeDropped(const std::filesystem::path& file);

  /// Of saveState(): another number when docks are added or renamed.
  static constexpr int kLayoutVersion = 4;

  Session& session_;
  RecentFiles recent_;
  FileActions* files_ = nullptr;
  QStackedWidget* pages_ = nullptr;
  QWidget* workPage_ = nullptr;
  Gallery* gallery_ = nullptr;
  ProblemBar* problems_ = nullptr;
  Viewport* viewport_ = nullptr;
  std::vector<QDockWidget*> docks_;
  QMenu* viewMenu_ = nullptr;
  QMenu* simulateMenu_ = nullptr;
  QToolBar* toolBar_ = nullptr;
  PlayActions* playActions_ = nullptr;
  SceneActions* sceneActions_ = nullptr;
  AddActions* addActions_ = nullptr;
  PreflightDialog* preflight_ = nullptr;
  EditorActions* editorActions_ = nullptr;
  QLabel* hint_ = nullptr;
  QLabel* state_ = nullptr;
  bool previewProblem_ = false;  ///< the bar shows one of the preview
  int widthBeforeProfile_ = 0;   ///< of the docks at the left, logical pixels; 0: not known
  QByteArray firstLayout_;       ///< as it comes out of the box
};

}  // namespace ui
