#include "ui/window/main_window.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QProgressBar>
#include <QStatusBar>
#include <QToolBar>

#include "ui/theme/theme.h"
#include "ui/timeline/play_actions.h"
#include "ui/timeline/timeline.h"
#include "ui/viewport/viewport.h"

namespace ui {

MainWindow::MainWindow(Session& session, QWidget* parent) : QMainWindow(parent), session_(session) {
  setObjectName("main");
  resize(1280, 800);
  setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
  makeCentre();
  makeDocks();
  makeMenus();
  makeToolBar();
  makeStatusBar();
  connect(&session_.document(), &Document::statusChanged, this, &MainWindow::showTitle);
  connect(&session_, &Session::runChanged, this, &MainWindow::showRun);
  connect(&session_, &Session::previewChanged, this, &MainWindow::showRun);
  connect(&session_, &Session::problemFound, this, &MainWindow::showProblem);
  showTitle();
}

void MainWindow::makeCentre() {
  viewport_ = new Viewport(session_, this);
  setCentralWidget(viewport_);
}

void MainWindow::makeDocks() {
  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
  playActions_ = new PlayActions(session_, this);
  addActions(playActions_->findChildren<QAction*>(Qt::FindDirectChildrenOnly));
  qApp->installEventFilter(new KeysOfFocus(this));
  auto* timeline = new Timeline(session_, *playActions_, this);
  QDockWidget* dock = addDock(QStringLiteral("timeline"), tr("Timeline"), timeline, Qt::BottomDockWidgetArea);
  // It has no name to show and nowhere better to be; its room is for the time.
  dock->setTitleBarWidget(new QWidget(dock));
  dock->setFeatures(QDockWidget::NoDockWidgetFeatures);
}
void MainWindow::makeMenus() {}
void MainWindow::makeToolBar() {}

void MainWindow::makeStatusBar() {
  hint_ = new QLabel(this);
  state_ = new QLabel(this);
  progress_ = new QProgressBar(this);
  progress_->setFixedWidth(160);
  progress_->setTextVisible(false);
  progress_->hide();
  statusBar()->addWidget(hint_, 1);
  statusBar()->addPermanentWidget(progress_);
  statusBar()->addPermanentWidget(state_);
}

QDockWidget* MainWindow::addDock(const QString& name, const QString& title, QWidget* content,
                                 Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWidget(content);
  addDockWidget(area, dock);
  return dock;
}

void MainWindow::showTitle() {
  setWindowTitle(session_.document().title() + QStringLiteral("[*]"));
  setWindowModified(session_.document().isModified());
}

void MainWindow::showRun() {
  const std::shared_ptr<const RunView>& run = session_.run();
  progress_->setVisible(session_.hasRun());
  if (run->newest && run->until > 0.0)
    progress_->setValue(static_cast<int>(100.0 * run->newest->time / run->until));
  state_->setText(session_.isBuilding() ? tr("Building") : QString());
}

void MainWindow::showProblem(const sim::Problem& problem) {
  hint_->setText(QString::fromStdString(problem.line()));
}

void MainWindow::closeEvent(QCloseEvent* event) {
  session_.stopRun();
  event->accept();
}

}  // namespace ui
