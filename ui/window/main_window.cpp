#include "ui/window/main_window.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QSettings>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTimer>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/document/place_words.h"
#include "ui/editors/editor_actions.h"
#include "ui/panels/add_actions.h"
#include "ui/panels/empty_scene.h"
#include "ui/panels/scene_actions.h"
#include "ui/panels/take_photographer.h"
#include "ui/theme/theme.h"
#include "ui/timeline/play_actions.h"
#include "ui/viewport/viewport.h"
#include "ui/window/docks.h"
#include "ui/window/focus_order.h"
#include "ui/window/gallery.h"
#include "ui/window/menus.h"
#include "ui/window/problem_bar.h"
#include "ui/window/view_memory.h"

namespace ui {
namespace {

bool canDrop(const std::filesystem::path& file) {
  return FileActions::canOpen(file) || AddActions::isMesh(file);
}

/// A file that takes long can be given up here.
QString buildingText(const Session& session) {
  const QString words = QString::fromStdString(session.waitingFor()).toHtmlEscaped();
  if (words.isEmpty()) return MainWindow::tr("Building");
  return MainWindow::tr("%1 <a href=\"giveUp\">Give Up</a>").arg(words);
}

}  // namespace

MainWindow::MainWindow(Session& session, QWidget* parent) : QMainWindow(parent), session_(session) {
  setObjectName("main");
  resize(1280, 800);
  setAcceptDrops(true);
  setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  actions_.files = new FileActions(session_, recent_, this);
  makeCentre();
  makeActions();
  docks_ = new Docks(*this, session_, *viewport_, actions_);
  new TakePhotographer(session_, *viewport_, this);
  makeMenus({*this, session_, *viewport_, *docks_, actions_, [this] { showGallery(); }});
  makeToolBar();
  makeStatusBar();
  connect(actions_.files, &FileActions::opened, this, &MainWindow::showViewport);
  connect(&session_.document(), &Document::statusChanged, this, &MainWindow::showTitle);
  connect(&session_, &Session::runChanged, this, &MainWindow::showRun);
  connect(&session_, &Session::waitingChanged, this, &MainWindow::showRun);
  connect(&session_, &Session::previewChanged, this, &MainWindow::showPreviewProblem);
  connect(&session_, &Session::problemFound, this, &MainWindow::showProblem);
  viewport_->setViewSettings(recallView());
  connect(viewport_, &Viewport::viewSettingsChanged, this,
          [this] { rememberView(viewport_->viewSettings()); });
  showTitle();
  docks_->markFirstLayout();
  recallLayout();
  showGallery();
}

MainWindow::~MainWindow() = default;

void MainWindow::makeCentre() {
  pages_ = new QStackedWidget(this);
  workPage_ = new QWidget(pages_);
  auto* layout = new QVBoxLayout(workPage_);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  problems_ = new ProblemBar(workPage_);
  viewport_ = new Viewport(session_, workPage_);
  layout->addWidget(problems_);
  layout->addWidget(viewport_, 1);
  gallery_ = new Gallery(recent_, pages_);
  connect(gallery_, &Gallery::newWanted, actions_.files, &FileActions::newScene);
  connect(gallery_, &Gallery::openWanted, actions_.files->openAction(), &QAction::trigger);
  connect(gallery_, &Gallery::fileWanted, actions_.files, &FileActions::open);
  pages_->addWidget(gallery_);
  pages_->addWidget(workPage_);
  setCentralWidget(pages_);
}

void MainWindow::makeActions() {
  actions_.scene = new SceneActions(session_, this);
  actions_.add = new AddActions(session_, this);
  new EmptyScene(session_, *actions_.add, viewport_);
  actions_.play = new PlayActions(session_, this);
  addActions(actions_.play->findChildren<QAction*>(Qt::FindDirectChildrenOnly));
  qApp->installEventFilter(new KeysOfFocus(this));
  actions_.editors = new EditorActions(session_, *viewport_, this);
  addAction(actions_.editors->glue());
}

void MainWindow::makeToolBar() {
  toolBar_ = addToolBar(tr("Tools"));
  toolBar_->setObjectName("tools");
  toolBar_->setMovable(false);
  toolBar_->setIconSize(QSize(18, 18));
  toolBar_->addAction(actions_.files->newAction());
  toolBar_->addAction(actions_.files->openAction());
  toolBar_->addAction(actions_.files->saveAction());
  toolBar_->addSeparator();
  toolBar_->addAction(actions_.add->openAction());
  toolBar_->addSeparator();
  toolBar_->addAction(actions_.play->simulate);
}

void MainWindow::makeStatusBar() {
  auto* hint = new QLabel(this);
  hint->setForegroundRole(QPalette::PlaceholderText);
  hint->setIndent(6);
  state_ = new QLabel(this);
  state_->setObjectName(QStringLiteral("building"));
  connect(state_, &QLabel::linkActivated, this, [this] { session_.giveUpReading(); });
  statusBar()->setSizeGripEnabled(false);
  statusBar()->addWidget(hint, 1);
  statusBar()->addPermanentWidget(state_);
  connect(viewport_, &Viewport::hintChanged, hint, &QLabel::setText);
}

bool MainWindow::showsGallery() const {
  return pages_->currentWidget() == gallery_;
}

void MainWindow::rememberLayout() const {
  QSettings().setValue("window/geometry", saveGeometry());
  if (!showsGallery()) docks_->rememberLayout();
}

void MainWindow::recallLayout() {
  restoreGeometry(QSettings().value("window/geometry").toByteArray());
  docks_->recallLayout();
}

void MainWindow::showGallery() {
  if (!showsGallery() && isVisible()) {
    keepPicture();
    rememberLayout();
  }
  docks_->hideAll();
  toolBar_->hide();
  statusBar()->hide();
  pages_->setCurrentWidget(gallery_);
}

void MainWindow::showViewport() {
  if (!showsGallery()) return;
  pages_->setCurrentWidget(workPage_);
  toolBar_->show();
  statusBar()->show();
  if (!docks_->recallLayout()) docks_->useFirstLayout();
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
  state_->setText(session_.isBuilding() && !session_.hasRun() ? buildingText(session_) : QString());
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
  if (showsGallery() && !problems_->isVisible())
    QMessageBox::warning(this, tr("Smithereens"), QString::fromStdString(problem.line()));
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!actions_.files->mayLeave()) {
    event->ignore();
    return;
  }
  session_.stopRun();
  keepPicture();
  rememberLayout();
  event->accept();
}

/// Over the picture Tab is its shortcut, also where a list has the keyboard: what was clicked there is what
/// is to be edited. In fields it goes from one to the next wherever the pointer is.
bool MainWindow::editsPoints() {
  const bool inList = qobject_cast<QAbstractItemView*>(QApplication::focusWidget()) != nullptr;
  QAction* points = actions_.editors->editPoints();
  if (!inList || !viewport_->underMouse() || !points->isEnabled()) return false;
  viewport_->setFocus(Qt::ShortcutFocusReason);
  points->trigger();
  return true;
}

/// What no panel wants.
void MainWindow::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && !showsGallery() && viewport_->leaveTool()) return;
  QMainWindow::keyPressEvent(event);
}

bool MainWindow::focusNextPrevChild(bool next) {
  if (next && editsPoints()) return true;
  return moveFocus(*this, next) || QMainWindow::focusNextPrevChild(next);
}

/// A mesh comes into the scene that is open, or into a new one.
void MainWindow::takeDropped(const std::filesystem::path& file) {
  if (!AddActions::isMesh(file)) return actions_.files->open(file);
  if (showsGallery()) actions_.files->newScene();
  if (!showsGallery()) actions_.add->askAboutMesh(file);
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
