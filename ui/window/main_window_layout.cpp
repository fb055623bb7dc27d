#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>

#include "ui/editors/editor_actions.h"
#include "ui/editors/profile_editor.h"
#include "ui/panels/add_actions.h"
#include "ui/panels/diagnostics_panel.h"
#include "ui/panels/empty_scene.h"
#include "ui/panels/inspector_panel.h"
#include "ui/panels/live_panel.h"
#include "ui/panels/outliner.h"
#include "ui/panels/properties.h"
#include "ui/panels/scene_actions.h"
#include "ui/panels/take_photographer.h"
#include "ui/panels/takes_panel.h"
#include "ui/theme/theme.h"
#include "ui/timeline/play_actions.h"
#include "ui/timeline/timeline.h"
#include "ui/viewport/viewport.h"
#include "ui/window/gallery.h"
#include "ui/window/main_window.h"
#include "ui/window/problem_bar.h"

namespace ui {

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
  connect(gallery_, &Gallery::newWanted, files_, &FileActions::newScene);
  connect(gallery_, &Gallery::openWanted, files_->openAction(), &QAction::trigger);
  connect(gallery_, &Gallery::fileWanted, files_, &FileActions::open);
  pages_->addWidget(gallery_);
  pages_->addWidget(workPage_);
  setCentralWidget(pages_);
}

void MainWindow::makeDocks() {
  sceneActions_ = new SceneActions(session_, this);
  addActions_ = new AddActions(session_, this);
  new EmptyScene(session_, *addActions_, viewport_);
  QDockWidget* outliner = addDock(QStringLiteral("outliner"), tr("Outliner"),
                                  new Outliner(session_, *sceneActions_, this), Qt::LeftDockWidgetArea);
  QDockWidget* properties = addDock(QStringLiteral("properties"), tr("Properties"),
                                    new Properties(session_, this), Qt::RightDockWidgetArea);
  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
  playActions_ = new PlayActions(session_, this);
  addActions(playActions_->findChildren<QAction*>(Qt::FindDirectChildrenOnly));
  qApp->installEventFilter(new KeysOfFocus(this));
  auto* timeline = new Timeline(session_, *playActions_, this);
  QDockWidget* dock = addDock(QStringLiteral("timeline"), tr("Timeline"), timeline, Qt::BottomDockWidgetArea);
  auto* plots = new DiagnosticsPanel(session_, timeline->feed(), timeline->axis(), this);
  QDockWidget* plotsDock =
      addDock(QStringLiteral("diagnostics"), tr("Diagnostics"), plots, Qt::BottomDockWidgetArea);
  splitDockWidget(plotsDock, dock, Qt::Vertical);
  plotsDock->toggleViewAction()->setShortcut(QKeySequence(Qt::Key_F9));
  plotsDock->hide();
  QDockWidget* live =
      addDock(QStringLiteral("live"), tr("Live"), new LivePanel(session_, *viewport_, *playActions_, this),
              Qt::RightDockWidgetArea);
  QDockWidget* inspector = addDock(QStringLiteral("inspector"), tr("Inspector"),
                                   new InspectorPanel(session_, *viewport_, this), Qt::RightDockWidgetArea);
  tabifyDockWidget(properties, live);
  tabifyDockWidget(live, inspector);
  tabifyDockWidget(outliner, addDock(QStringLiteral("takes"), tr("Takes"),
                                     new TakesPanel(session_, *playActions_, this), Qt::LeftDockWidgetArea));
  new TakePhotographer(session_, *viewport_, this);
  // It has no name to show and nowhere better to be; its room is for the time.
  dock->setTitleBarWidget(new QWidget(dock));
  dock->setFeatures(QDockWidget::NoDockWidgetFeatures);
  makeEditors();
}

void MainWindow::makeEditors() {
  editorActions_ = new EditorActions(session_, *viewport_, this);
  addAction(editorActions_->glue());
  QDockWidget* profile = addDock(QStringLiteral("profile"), tr("Profile"), new ProfileEditor(session_, this),
                                 Qt::LeftDockWidgetArea);
  tabifyDockWidget(findChild<QDockWidget*>(QStringLiteral("outliner")), profile);
  profile->hide();
  connect(editorActions_, &EditorActions::profileWanted, this, [this, profile] { toggleProfile(*profile); });
}

/// Puts it before the outliner, made wide enough to draw; where it is there already, takes it away again.
void MainWindow::toggleProfile(QDockWidget& profile) {
  constexpr int kRoomToDraw = 460;  // logical pixels
  if (profile.isVisible() && !profile.visibleRegion().isEmpty()) {
    profile.hide();
    auto* outliner = findChild<QDockWidget*>(QStringLiteral("outliner"));
    outliner->raise();
    if (widthBeforeProfile_ > 0) resizeDocks({outliner}, {widthBeforeProfile_}, Qt::Horizontal);
    return;
  }
  const auto* beside = findChild<QDockWidget*>(QStringLiteral("outliner"));
  widthBeforeProfile_ = beside->width();
  profile.show();
  profile.raise();
  if (profile.width() < kRoomToDraw) resizeDocks({&profile}, {kRoomToDraw}, Qt::Horizontal);
  if (profile.height() < kRoomToDraw) resizeDocks({&profile}, {kRoomToDraw}, Qt::Vertical);
}

void MainWindow::useFirstLayout() {
  // Logical pixels: names, and two columns of a form; the rest is for the picture.
  constexpr int kOutlinerWidth = 236;
  constexpr int kPropertiesWidth = 336;
  restoreState(firstLayout_, kLayoutVersion);
  QList<QDockWidget*> sides;
  for (const char* name : {"outliner", "properties"}) {
    sides.append(findChild<QDockWidget*>(QString::fromLatin1(name)));
    sides.back()->raise();
  }
  resizeDocks(sides, {kOutlinerWidth, kPropertiesWidth}, Qt::Horizontal);
}

QDockWidget* MainWindow::addDock(const QString& name, const QString& title, QWidget* content,
                                 Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWidget(content);
  // At the sides docks are tabs, which have their names already.
  if (area != Qt::BottomDockWidgetArea) dock->setTitleBarWidget(new QWidget(dock));
  addDockWidget(area, dock);
  docks_.push_back(dock);
  return dock;
}

void MainWindow::makeToolBar() {
  toolBar_ = addToolBar(tr("Tools"));
  toolBar_->setObjectName("tools");
  toolBar_->setMovable(false);
  toolBar_->setIconSize(QSize(18, 18));
  toolBar_->addAction(files_->newAction());
  toolBar_->addAction(files_->openAction());
  toolBar_->addAction(files_->saveAction());
  toolBar_->addSeparator();
  toolBar_->addAction(addActions_->openAction());
  toolBar_->addSeparator();
  toolBar_->addAction(playActions_->simulate);
}

void MainWindow::makeStatusBar() {
  hint_ = new QLabel(this);
  hint_->setForegroundRole(QPalette::PlaceholderText);
  hint_->setIndent(6);
  state_ = new QLabel(this);
  statusBar()->setSizeGripEnabled(false);
  statusBar()->addWidget(hint_, 1);
  statusBar()->addPermanentWidget(state_);
  connect(viewport_, &Viewport::hintChanged, hint_, &QLabel::setText);
}

}  // namespace ui
