#include <QActionGroup>
#include <QDockWidget>
#include <QMenuBar>
#include <QSettings>

#include "ui/editors/editor_actions.h"
#include "ui/panels/add_actions.h"
#include "ui/panels/long_run_notice.h"
#include "ui/panels/preflight_dialog.h"
#include "ui/panels/scene_actions.h"
#include "ui/theme/theme.h"
#include "ui/timeline/play_actions.h"
#include "ui/viewport/view_actions.h"
#include "ui/viewport/view_bars.h"
#include "ui/viewport/viewport.h"
#include "ui/window/about_dialog.h"
#include "ui/window/focus_order.h"
#include "ui/window/main_window.h"
#include "ui/window/shortcuts_dialog.h"

namespace ui {

void MainWindow::makeMenus() {
  makeFileMenu();
  makeEditMenu();
  makeViewMenu();
  makeSimulateMenu();
  makeHelpMenu();
}

void MainWindow::makeFileMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  files_->addTo(*menu);
  menu->addSeparator();
  menu->addAction(editorActions_->render());
  menu->addAction(Theme::icon("grid"), tr("&Gallery"), this, &MainWindow::showGallery);
  menu->addSeparator();
  menu->addAction(tr("&Quit"), QKeySequence::Quit, this, &QWidget::close);
}

void MainWindow::makeEditMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Edit"));
  QUndoStack& history = session_.document().undoStack();
  QAction* undo = history.createUndoAction(menu, tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  undo->setIcon(Theme::icon("undo"));
  QAction* redo = history.createRedoAction(menu, tr("&Redo"));
  redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  redo->setIcon(Theme::icon("redo"));
  menu->addAction(undo);
  menu->addAction(redo);
  menu->addSeparator();
  sceneActions_->fill(*menu);
  menu->addSeparator();
  menu->addActions({editorActions_->editPoints(), editorActions_->glue(), editorActions_->tuneThreshold()});
  addActions_->fill(*menuBar()->addMenu(tr("&Add")));
}

void MainWindow::makeNavigationMenu() {
  QMenu* menu = viewMenu_->addMenu(tr("&Navigation"));
  auto* group = new QActionGroup(this);
  const bool isMaya = QSettings().value("navigation").toString() == "maya";
  const auto add = [&](const QString& name, const QString& tip, NavigationPreset preset, bool present) {
    QAction* action = menu->addAction(name, this, [this, preset] {
      viewport_->setNavigationPreset(preset);
      QSettings().setValue("navigation", preset == NavigationPreset::maya ? "maya" : "blender");
    });
    action->setToolTip(tip);
    action->setCheckable(true);
    action->setChecked(present);
    group->addAction(action);
  };
  menu->setToolTipsVisible(true);
  add(tr("As in &Blender"), tr("Middle button: orbit; with Shift: pan; with Ctrl or the wheel: zoom"),
      NavigationPreset::blender, !isMaya);
  add(tr("As in &Maya"), tr("With Alt, left button: orbit; middle: pan; right: zoom"), NavigationPreset::maya,
      isMaya);
  if (isMaya) viewport_->setNavigationPreset(NavigationPreset::maya);
}

void MainWindow::makeViewMenu() {
  viewMenu_ = menuBar()->addMenu(tr("&View"));
  auto* views = new ViewActions(*viewport_);
  new ViewBars(*viewport_, *views);
  views->addTo(*viewMenu_);
  makeNavigationMenu();
  viewMenu_->addSeparator();
  QMenu* panels = viewMenu_->addMenu(tr("&Panels"));
  for (QDockWidget* dock : docks_) panels->addAction(dock->toggleViewAction());
  panels->addSeparator();
  panels->addAction(tr("&Next Panel"), QKeySequence(Qt::Key_F6), this,
                    [this] { moveFocusToPlace(*this, true); });
  panels->addAction(tr("&Previous Panel"), QKeySequence(Qt::SHIFT | Qt::Key_F6), this,
                    [this] { moveFocusToPlace(*this, false); });
  panels->addAction(tr("&Reset Layout"), this, &MainWindow::useFirstLayout);
  QMenu* themes = viewMenu_->addMenu(tr("&Theme"));
  auto* group = new QActionGroup(this);
  const auto addTheme = [&](const QString& name, ThemeKind kind) {
    QAction* action = themes->addAction(name, this, [kind] {
      Theme::instance().apply(kind);
      QSettings().setValue("theme", kind == ThemeKind::dark ? "dark" : "light");
    });
    action->setCheckable(true);
    action->setChecked(Theme::instance().kind() == kind);
    group->addAction(action);
  };
  addTheme(tr("&Dark"), ThemeKind::dark);
  addTheme(tr("&Light"), ThemeKind::light);
}

void MainWindow::makeSimulateMenu() {
  simulateMenu_ = menuBar()->addMenu(tr("&Simulate"));
  const PlayActions& actions = *playActions_;
  simulateMenu_->addActions({actions.simulate, actions.toggle, actions.stop, actions.follow});
  simulateMenu_->addSeparator();
  simulateMenu_->addActions({actions.continueAsWas, actions.continueChanged, actions.record});
  simulateMenu_->addSeparator();
  simulateMenu_->addActions({actions.playBackwards, actions.stepBack, actions.stepForward, actions.toFirst,
                             actions.toLast, actions.toFirstBreak, actions.loop, actions.everyFrame});
  simulateMenu_->addSeparator();
  preflight_ = new PreflightDialog(session_, this);
  const auto preflight = [this] {
    preflight_->show();
    preflight_->raise();
    preflight_->look();
  };
  simulateMenu_->addAction(Theme::icon("preflight"), tr("Pre-&flight…"), QKeySequence(Qt::CTRL | Qt::Key_P),
                           this, preflight);
  auto* longRun = new LongRunNotice(session_, viewport_);
  connect(longRun, &LongRunNotice::preflightWanted, this, preflight);
  simulateMenu_->addAction(tr("Show the Scene at &Rest"), QKeySequence(Qt::CTRL | Qt::Key_Home), &session_,
                           &Session::showEdited);
}

void MainWindow::makeHelpMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Help"));
  menu->addAction(tr("&Shortcuts"), QKeySequence(Qt::Key_F1), this, [this] {
    ShortcutsDialog dialog(*this);
    dialog.exec();
  });
  menu->addAction(tr("&About Smithereens"), this, [this] {
    AboutDialog dialog(this);
    dialog.exec();
  });
}

}  // namespace ui
