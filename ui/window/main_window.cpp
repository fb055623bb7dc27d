#include "ui/window/main_window.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <algorithm>

#include "ui/document/place_words.h"
#include "ui/files/autosave.h"
#include "ui/panels/add_actions.h"
#include "ui/theme/theme.h"
#include "ui/viewport/viewport.h"
#include "ui/window/focus_order.h"
#include "ui/window/gallery.h"
#include "ui/window/problem_bar.h"
#include "ui/window/view_memory.h"

namespace ui {
namespace {

bool canDrop(const std::filesystem::path& file) {
  return FileActions::canOpen(file) || AddActions::isMesh(file);
}

}  // namespace

MainWindow::MainWindow(Session& session, QWidget* parent) : QMainWindow(parent), session_(session) {
  setObjectName("main");
  resize(1280, 800);
  setAcceptDrops(true);
  setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  files_ = new FileActions(session_, recent_, this);
  makeCentre();
  makeDocks();
  makeMenus();
  makeToolBar();
  makeStatusBar();
  connect(files_, &FileActions::opened, this, &MainWindow::showViewport);
  connect(&session_.document(), &Document::statusChanged, this, &MainWindow::showTitle);
  connect(&session_, &Session::runChanged, this, &MainWindow::showRun);
  connect(&session_, &Session::previewChanged, this, &MainWindow::showPreviewProblem);
  connect(&session_, &Session::problemFound, this, &MainWindow::showProblem);
  viewport_->setViewSettings(recallView());
  connect(viewport_, &Viewport::viewSettingsChanged, this,
          [this] { rememberView(viewport_->viewSettings()); });
  showTitle();
  firstLayout_ = saveState(kLayoutVersion);
  recallLayout();
  showGallery();
}

MainWindow::~MainWindow() = default;

void MainWindow::rememberLayout() const {
  QSettings settings;
  settings.setValue("window/geometry", saveGeometry());
  if (pages_->currentWidget() == workPage_) settings.setValue("window/state", saveState(kLayoutVersion));
}

void MainWindow::recallLayout() {
  const QSettings settings;
  restoreGeometry(settings.value("window/geometry").toByteArray());
  restoreState(settings.value("window/state").toByteArray(), kLayoutVersion);
}

void MainWindow::showGallery() {
  if (pages_->currentWidget() == workPage_ && isVisible()) {
    keepPicture();
    rememberLayout();
  }
  for (QDockWidget* dock : docks_) dock->hide();
  toolBar_->hide();
  statusBar()->hide();
  pages_->setCurrentWidget(gallery_);
}

void MainWindow::showViewport() {
  if (pages_->currentWidget() == workPage_) return;
  pages_->setCurrentWidget(workPage_);
  const QByteArray state = QSettings().value("window/state").toByteArray();
  toolBar_->show();
  statusBar()->show();
  if (state.isEmpty() || !restoreState(state, kLayoutVersion)) useFirstLayout();
  viewport_->setFocus();
}

/// The recent files show what was last seen of them.
void MainWindow::keepPicture() {
  const std::filesystem::path& file = session_.document().file();
  if (file.empty() || !viewport_->isVisible()) return;
  const QImage picture = viewport_->grabFramebuffer();
  recent_.setPicture(file,
                     picture.scaled(480, 300, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation));
}

void MainWindow::showTitle() {
  setWindowTitle(session_.document().title() + QStringLiteral("[*]"));
  setWindowModified(session_.document().isModified());
}

/// How far a run is, is said beside the timeline.
void MainWindow::showRun() {
  const std::shared_ptr<const RunView>& run = session_.run();
  state_->setText(session_.isBuilding() && !session_.hasRun() ? tr("Building") : QString());
  if (session_.hasRun() && run->phase == RunPhase::paused && run->problem) showProblem(*run->problem);
}

void MainWindow::showPreviewProblem() {
  showRun();
  const std::optional<sim::Problem>& problem = session_.preview()->problem;
  if (problem) {
    problems_->show(*problem, placeInWords(session_.preview()->scene, problem->place));
  } else if (previewProblem_) {
    problems_->putAway();
  }
  previewProblem_ = problem.has_value();
}

void MainWindow::showProblem(const sim::Problem& problem) {
  previewProblem_ = false;
  problems_->show(problem, placeInWords(session_.document().scene(), problem.place));
  if (pages_->currentWidget() == gallery_ && !problems_->isVisible())
    QMessageBox::warning(this, tr("Smithereens"), QString::fromStdString(problem.line()));
}

void MainWindow::offerLeftovers(const std::filesystem::path& root) {
  for (const Leftover& leftover : Autosave::leftovers(root)) {
    const QString name =
        leftover.scene.name.empty() ? tr("Untitled") : QString::fromStdString(leftover.scene.name);
    QMessageBox question(QMessageBox::Question, tr("Recover"),
                         tr("“%1” was not saved when the program ended unexpectedly.").arg(name),
                         QMessageBox::NoButton, this);
    question.setInformativeText(
        tr("It was kept at %1.").arg(QLocale().toString(leftover.when, QLocale::ShortFormat)));
    QPushButton* recover = question.addButton(tr("Recover"), QMessageBox::AcceptRole);
    QPushButton* discard = question.addButton(tr("Discard"), QMessageBox::DestructiveRole);
    question.addButton(tr("Later"), QMessageBox::RejectRole);
    question.setDefaultButton(recover);
    question.exec();
    if (question.clickedButton() == static_cast<QAbstractButton*>(discard)) Autosave::discard(leftover);
    if (question.clickedButton() != static_cast<QAbstractButton*>(recover)) continue;
    session_.document().reset(leftover.scene, leftover.file);
    session_.document().markUnsaved();
    session_.takes().adopt(leftover.takes);
    Autosave::discard(leftover);
    showViewport();
    return;
  }
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!files_->mayLeave()) {
    event->ignore();
    return;
  }
  session_.stopRun();
  keepPicture();
  rememberLayout();
  event->accept();
}

bool MainWindow::focusNextPrevChild(bool next) {
  return moveFocus(*this, next) || QMainWindow::focusNextPrevChild(next);
}

/// A mesh comes into the scene that is open, or into a new one.
void MainWindow::takeDropped(const std::filesystem::path& file) {
  if (!AddActions::isMesh(file)) return files_->open(file);
  if (pages_->currentWidget() == gallery_) files_->newScene();
  if (pages_->currentWidget() == workPage_) addActions_->askAboutMesh(file);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const QList<QUrl> urls = event->mimeData()->urls();
  const bool wanted = std::any_of(urls.begin(), urls.end(), [](const QUrl& url) {
    return url.isLocalFile() && canDrop(url.toLocalFile().toStdString());
  });
  if (wanted) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  std::vector<std::filesystem::path> files;
  for (const QUrl& url : event->mimeData()->urls()) {
    if (url.isLocalFile() && canDrop(url.toLocalFile().toStdString()))
      files.emplace_back(url.toLocalFile().toStdString());
  }
  event->acceptProposedAction();
  // Questions that opening asks must not keep the program waiting that the file was dragged from.
  QTimer::singleShot(0, this, [this, files] {
    for (const std::filesystem::path& file : files) takeDropped(file);
  });
}

}  // namespace ui
