#include "ui/window/docks.h"

#include <QAction>
#include <QDockWidget>
#include <QMainWindow>
#include <QSettings>

#include "ui/editors/editor_actions.h"
#include "ui/editors/profile_editor.h"
#include "ui/panels/diagnostics_panel.h"
#include "ui/panels/inspector_panel.h"
#include "ui/panels/live_panel.h"
#include "ui/panels/outliner.h"
#include "ui/panels/properties.h"
#include "ui/panels/takes_panel.h"
#include "ui/timeline/play_actions.h"
#include "ui/timeline/timeline.h"
#include "ui/viewport/viewport.h"

namespace ui {
namespace {

/// Of saveState(): another number when docks are added or renamed.
constexpr int kLayoutVersion = 4;

}  // namespace

Docks::Docks(QMainWindow& window, Session& session, Viewport& viewport, const WindowActions& actions)
    : QObject(&window), window_(window) {
  window.setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  window.setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
  outliner_ = addDock(QStringLiteral("outliner"), tr("Outliner"),
                      new Outliner(session, *actions.scene, &window), Qt::LeftDockWidgetArea);
  properties_ = addDock(QStringLiteral("properties"), tr("Properties"), new Properties(session, &window),
                        Qt::RightDockWidgetArea);
  makeBottom(session, actions);
  makeSides(session, viewport, actions);
  makeProfile(session, actions);
}

void Docks::makeBottom(Session& session, const WindowActions& actions) {
  auto* timeline = new Timeline(session, *actions.play, &window_);
  QDockWidget* dock = addDock(QStringLiteral("timeline"), tr("Timeline"), timeline, Qt::BottomDockWidgetArea);
  auto* plots = new DiagnosticsPanel(session, timeline->feed(), timeline->axis(), &window_);
  QDockWidget* plotsDock =
      addDock(QStringLiteral("diagnostics"), tr("Diagnostics"), plots, Qt::BottomDockWidgetArea);
  window_.splitDockWidget(plotsDock, dock, Qt::Vertical);
  plotsDock->toggleViewAction()->setShortcut(QKeySequence(Qt::Key_F9));
  plotsDock->hide();
  // It has no name to show and nowhere better to be; its room is for the time.
  dock->setTitleBarWidget(new QWidget(dock));
  dock->setFeatures(QDockWidget::NoDockWidgetFeatures);
}

/// Behind outliner and properties.
void Docks::makeSides(Session& session, Viewport& viewport, const WindowActions& actions) {
  QDockWidget* live =
      addDock(QStringLiteral("live"), tr("Live"), new LivePanel(session, viewport, *actions.play, &window_),
              Qt::RightDockWidgetArea);
  QDockWidget* inspector = addDock(QStringLiteral("inspector"), tr("Inspector"),
                                   new InspectorPanel(session, viewport, &window_), Qt::RightDockWidgetArea);
  window_.tabifyDockWidget(properties_, live);
  window_.tabifyDockWidget(live, inspector);
  QDockWidget* takes = addDock(QStringLiteral("takes"), tr("Takes"),
                               new TakesPanel(session, *actions.play, &window_), Qt::LeftDockWidgetArea);
  window_.tabifyDockWidget(outliner_, takes);
}

void Docks::makeProfile(Session& session, const WindowActions& actions) {
  profile_ = addDock(QStringLiteral("profile"), tr("Profile"), new ProfileEditor(session, &window_),
                     Qt::LeftDockWidgetArea);
  window_.tabifyDockWidget(outliner_, profile_);
  profile_->hide();
  connect(actions.editors, &EditorActions::profileWanted, this, &Docks::toggleProfile);
}

QDockWidget* Docks::addDock(const QString& name, const QString& title, QWidget* content,
                            Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, &window_);
  dock->setObjectName(name);
  dock->setWidget(content);
  // At the sides docks are tabs, which have their names already.
  if (area != Qt::BottomDockWidgetArea) dock->setTitleBarWidget(new QWidget(dock));
  window_.addDockWidget(area, dock);
  docks_.push_back(dock);
  return dock;
}

void Docks::hideAll() {
  for (QDockWidget* dock : docks_) dock->hide();
}

/// Puts it before the outliner, made wide enough to draw; where it is there already, takes it away again.
void Docks::toggleProfile() {
  constexpr int kRoomToDraw = 460;  // logical pixels
  if (profile_->isVisible() && !profile_->visibleRegion().isEmpty()) {
    profile_->hide();
    outliner_->raise();
    if (widthBeforeProfile_ > 0) window_.resizeDocks({outliner_}, {widthBeforeProfile_}, Qt::Horizontal);
    return;
  }
  widthBeforeProfile_ = outliner_->width();
  profile_->show();
  profile_->raise();
  if (profile_->width() < kRoomToDraw) window_.resizeDocks({profile_}, {kRoomToDraw}, Qt::Horizontal);
  if (profile_->height() < kRoomToDraw) window_.resizeDocks({profile_}, {kRoomToDraw}, Qt::Vertical);
}

void Docks::markFirstLayout() {
  firstLayout_ = window_.saveState(kLayoutVersion);
}

void Docks::useFirstLayout() {
  // Logical pixels: names, and two columns of a form; the rest is for the picture.
  constexpr int kOutlinerWidth = 236;
  constexpr int kPropertiesWidth = 336;
  window_.restoreState(firstLayout_, kLayoutVersion);
  outliner_->raise();
  properties_->raise();
  window_.resizeDocks({outliner_, properties_}, {kOutlinerWidth, kPropertiesWidth}, Qt::Horizontal);
}

void Docks::rememberLayout() const {
  QSettings().setValue("window/state", window_.saveState(kLayoutVersion));
}

bool Docks::recallLayout() {
  const QByteArray state = QSettings().value("window/state").toByteArray();
  return !state.isEmpty() && window_.restoreState(state, kLayoutVersion);
}

}  // namespace ui
