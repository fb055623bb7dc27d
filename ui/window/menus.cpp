#include "ui/window/menus.h"

#include <QActionGroup>
#include <QCoreApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenuBar>
#include <QSettings>

#include "ui/editors/editor_actions.h"
#include "ui/files/file_actions.h"
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
#include "ui/window/docks.h"
#include "ui/window/focus_order.h"
#include "ui/window/shortcuts_dialog.h"

namespace ui {
namespace {

/// Makes one menu after the other.
class Menus {
  Q_DECLARE_TR_FUNCTIONS(ui::MainWindow)

 public:
  explicit Menus(const MenuTargets& targets) : targets_(targets), actions_(targets.actions) {}

  void makeFileMenu();
  void makeEditMenu();
  void makeViewMenu();
  void makeSimulateMenu();
  void makeHelpMenu();

 private:
  void makeNavigationMenu(QMenu& view);
  void makePanelsMenu(QMenu& view);
  void makeThemeMenu(QMenu& view);

  const MenuTargets& targets_;
  const WindowActions& actions_;
};

void Menus::makeFileMenu() {
  QMenu* menu = targets_.window.menuBar()->addMenu(tr("&File"));
  actions_.files->addTo(*menu);
  menu->addSeparator();
  menu->addAction(actions_.editors->render());
  menu->addAction(Theme::icon("grid"), tr("&Gallery"), &targets_.window, targets_.showGallery);
  menu->addSeparator();
  menu->addAction(tr("&Quit"), QKeySequence::Quit, &targets_.window, &QWidget::close);
}

void Menus::makeEditMenu() {
  QMenu* menu = targets_.window.menuBar()->addMenu(tr("&Edit"));
  QUndoStack& history = targets_.session.document().undoStack();
  QAction* undo = history.createUndoAction(menu, tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  undo->setIcon(Theme::icon("undo"));
  QAction* redo = history.createRedoAction(menu, tr("&Redo"));
  redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
  redo->setIcon(Theme::icon("redo"));
  menu->addAction(undo);
  menu->addAction(redo);
  menu->addSeparator();
  actions_.scene->fill(*menu);
  menu->addSeparator();
  menu->addActions(
      {actions_.editors->editPoints(), actions_.editors->glue(), actions_.editors->tuneThreshold()});
  actions_.add->fill(*targets_.window.menuBar()->addMenu(tr("&Add")));
}

void Menus::makeNavigationMenu(QMenu& view) {
  QMenu* menu = view.addMenu(tr("Na&vigation"));
  auto* group = new QActionGroup(&targets_.window);
  const bool isMaya = QSettings().value("navigation").toString() == "maya";
  const auto add = [&](const QString& name, const QString& tip, NavigationPreset preset, bool present) {
    QAction* action = menu->addAction(name, &targets_.window, [&viewport = targets_.viewport, preset] {
      viewport.setNavigationPreset(preset);
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
  if (isMaya) targets_.viewport.setNavigationPreset(NavigationPreset::maya);
}

void Menus::makePanelsMenu(QMenu& view) {
  QMenu* panels = view.addMenu(tr("&Panels"));
  for (QDockWidget* dock : targets_.docks.all()) panels->addAction(dock->toggleViewAction());
  QMainWindow& window = targets_.window;
  panels->addSeparator();
  panels->addAction(tr("&Next Panel"), QKeySequence(Qt::Key_F6), &window,
                    [&window] { moveFocusToPlace(window, true); });
  panels->addAction(tr("&Previous Panel"), QKeySequence(Qt::SHIFT | Qt::Key_F6), &window,
                    [&window] { moveFocusToPlace(window, false); });
  panels->addAction(tr("&Reset Layout"), &targets_.docks, &Docks::useFirstLayout);
}

void Menus::makeThemeMenu(QMenu& view) {
  QMenu* themes = view.addMenu(tr("&Theme"));
  auto* group = new QActionGroup(&targets_.window);
  const auto addTheme = [&](const QString& name, ThemeKind kind) {
    QAction* action = themes->addAction(name, &targets_.window, [kind] {
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

void Menus::makeViewMenu() {
  QMenu* menu = targets_.window.menuBar()->addMenu(tr("&View"));
  auto* views = new ViewActions(targets_.viewport);
  new ViewBars(targets_.viewport, *views);
  views->addTo(*menu);
  makeNavigationMenu(*menu);
  menu->addSeparator();
  makePanelsMenu(*menu);
  makeThemeMenu(*menu);
}

void Menus::makeSimulateMenu() {
  QMenu* menu = targets_.window.menuBar()->addMenu(tr("&Simulate"));
  const PlayActions& actions = *actions_.play;
  menu->addActions({actions.simulate, actions.toggle, actions.stop, actions.follow});
  menu->addSeparator();
  menu->addActions({actions.continueAsWas, actions.continueChanged, actions.record});
  menu->addSeparator();
  menu->addActions({actions.playBackwards, actions.stepBack, actions.stepForward, actions.toFirst,
                    actions.toLast, actions.toFirstBreak, actions.loop, actions.everyFrame});
  menu->addSeparator();
  auto* dialog = new PreflightDialog(targets_.session, &targets_.window);
  const auto preflight = [dialog] {
    dialog->show();
    dialog->raise();
    dialog->look();
  };
  menu->addAction(Theme::icon("preflight"), tr("Pre-&flight…"), QKeySequence(Qt::CTRL | Qt::Key_P),
                  &targets_.window, preflight);
  auto* longRun = new LongRunNotice(targets_.session, &targets_.viewport);
  QObject::connect(longRun, &LongRunNotice::preflightWanted, dialog, preflight);
  menu->addAction(tr("Show the Scene at &Rest"), QKeySequence(Qt::CTRL | Qt::Key_Home), &targets_.session,
                  &Session::showEdited);
}

void Menus::makeHelpMenu() {
  QMainWindow& window = targets_.window;
  QMenu* menu = targets_.window.menuBar()->addMenu(tr("Hel&p"));
  menu->addAction(tr("&Shortcuts"), QKeySequence(Qt::Key_F1), &window, [&window] {
    ShortcutsDialog dialog(window);
    dialog.exec();
  });
  menu->addAction(tr("&About Smithereens"), &window, [&window] {
    AboutDialog dialog(&window);
    dialog.exec();
  });
}

}  // namespace

void makeMenus(const MenuTargets& targets) {
  Menus menus(targets);
  menus.makeFileMenu();
  menus.makeEditMenu();
  menus.makeViewMenu();
  menus.makeSimulateMenu();
  menus.makeHelpMenu();
}

}  // namespace ui
