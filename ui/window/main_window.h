#pragma once

#include <QMainWindow>
#include <filesystem>

#include "ui/files/file_actions.h"
#include "ui/files/recent_files.h"
#include "ui/session/session.h"
#include "ui/window/window_actions.h"

class QLabel;
class QStackedWidget;
class QToolBar;

namespace ui {

class Docks;
class Gallery;
class ProblemBar;
class Viewport;

/// The window: menus, bars, docks around the viewport. What it shows and does is the session's.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(Session& session, QWidget* parent = nullptr);
  ~MainWindow() override;

  Session& session() { return session_; }
  Viewport& viewport() { return *viewport_; }
  FileActions& files() { return *actions_.files; }

  /// The gallery in the viewport's place; the scene stays open behind it.
  void showGallery();
  void showViewport();

 protected:
  void closeEvent(QCloseEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  void keyPressEvent(QKeyEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  // Made once, in this order.
  void makeCentre();
  void makeActions();
  void makeToolBar();
  void makeStatusBar();

  bool showsGallery() const;
  bool editsPoints();
  void rememberLayout() const;
  void recallLayout();
  void showTitle();
  void showRun();
  void showPreviewProblem();
  void showProblem(const sim::Problem& problem);
  void keepPicture();
  void takeDropped(const std::filesystem::path& file);

  Session& session_;
  RecentFiles recent_;
  WindowActions actions_;
  QStackedWidget* pages_ = nullptr;
  QWidget* workPage_ = nullptr;
  Gallery* gallery_ = nullptr;
  ProblemBar* problems_ = nullptr;
  Viewport* viewport_ = nullptr;
  Docks* docks_ = nullptr;
  QToolBar* toolBar_ = nullptr;
  QLabel* state_ = nullptr;
  bool previewProblem_ = false;  ///< the bar shows one of the preview
};

}  // namespace ui
