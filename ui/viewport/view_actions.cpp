#include "ui/viewport/view_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

#include "ui/theme/theme.h"
#include "ui/viewport/transform_tool.h"
#include "ui/viewport/viewport.h"

namespace ui {

ViewActions::ViewActions(Viewport& viewport) : QObject(&viewport), viewport_(viewport) {
  makeTools();
  makeShows();
  makeViews();
  connect(&viewport_, &Viewport::toolChanged, this, &ViewActions::showTool);
  connect(&viewport_, &Viewport::viewSettingsChanged, this, &ViewActions::showSettings);
  showTool();
  showSettings();
}

QAction* ViewActions::make(const QString& text, const QString& icon, const QString& key, const QString& tip) {
  auto* action = new QAction(text, this);
  if (!icon.isEmpty()) action->setIcon(Theme::icon(icon));
  if (!key.isEmpty()) action->setShortcut(QKeySequence(key));
  const QString shown =
      key.isEmpty() ? QString()
                    : QStringLiteral(" (%1)").arg(action->shortcut().toString(QKeySequence::NativeText));
  action->setToolTip(QStringLiteral("<b>%1</b>%2<br>%3").arg(QString(text).remove('&'), shown, tip));
  viewport_.addAction(action);
  return action;
}

void ViewActions::makeTool(TransformMode mode, const QString& text, const QString& icon, const QString& key,
                           const QString& tip) {
  QAction* action = make(text, icon, key, tip);
  action->setCheckable(true);
  action->setData(static_cast<int>(mode));
  connect(action, &QAction::triggered, this, [this, mode] {
    auto* present = dynamic_cast<TransformTool*>(viewport_.tool());
    if (present == nullptr || present->mode() != mode) {
      auto tool = std::make_unique<TransformTool>(mode);
      tool->setSnaps(snap_->isChecked());
      present = tool.get();
      viewport_.setTool(std::move(tool));
    }
    // By its key, with the pointer over what is selected, it is in the hand at once.
    if (const QPoint pointer = viewport_.mapFromGlobal(QCursor::pos()); viewport_.underMouse()) {
      // Numbers and axes are typed next: they are meant for it, whichever panel had the keyboard.
      viewport_.setFocus(Qt::ShortcutFocusReason);
      present->grab(viewport_, pointer);
    }
    showTool();
  });
  tools_.push_back(action);
}

void ViewActions::makeTools() {
  QAction* select = make(tr("&Select"), QStringLiteral("select"), QStringLiteral("Q"),
                         tr("Click selects, with Shift adds or takes away."));
  select->setCheckable(true);
  connect(select, &QAction::triggered, this, [this] {
    viewport_.setTool(nullptr);
    showTool();
  });
  tools_.push_back(select);
  makeTool(
      TransformMode::move, tr("&Move"), QStringLiteral("move"), QStringLiteral("G"),
      tr("Drag a handle, or move the pointer and click. X, Y or Z holds to an axis; type a distance in cm."));
  makeTool(TransformMode::rotate, tr("&Rotate"), QStringLiteral("rotate"), QStringLiteral("R"),
           tr("Drag a ring, or move the pointer and click. X, Y or Z holds to an axis; type an angle in "
              "degrees."));
  makeTool(TransformMode::scale, tr("S&cale"), QStringLiteral("scale"), QStringLiteral("S"),
           tr("Drag a handle, or move the pointer and click. X, Y or Z holds to an axis; type a factor."));
  snap_ = make(tr("Snap"), QStringLiteral("snap"), {},
               tr("Moves by 1 cm, turns by 15°, scales by 0.1. Ctrl does the opposite while dragging."));
  snap_->setCheckable(true);
  connect(snap_, &QAction::toggled, this, [this](bool snaps) {
    if (auto* tool = dynamic_cast<TransformTool*>(viewport_.tool())) tool->setSnaps(snaps);
  });
}

void ViewActions::makeShow(bool ViewSettings::*what, const QString& text, const QString& icon,
                           const QString& key, const QString& tip) {
  QAction* action = make(text, icon, key, tip);
  action->setCheckable(true);
  connect(action, &QAction::triggered, this, [this, what](bool on) {
    ViewSettings settings = viewport_.viewSettings();
    settings.*what = on;
    viewport_.setViewSettings(settings);
  });
  shows_.push_back(action);
  shown_.push_back(what);
}

void ViewActions::makeShows() {
  makeShow(&ViewSettings::surface, tr("S&urface"), QStringLiteral("view-surface"), {},
           tr("The faces of whole cells."));
  makeShow(&ViewSettings::nodes, tr("&Nodes"), QStringLiteral("view-nodes"), {}, tr("Every node as a ball."));
  makeShow(&ViewSettings::bonds, tr("&Bonds"), QStringLiteral("view-bonds"), {},
           tr("Every bond, coloured by how near it is to breaking."));
  makeShow(&ViewSettings::xray, tr("&X-ray"), QStringLiteral("view-xray"), QStringLiteral("Alt+Z"),
           tr("Look through the surface."));
}

void ViewActions::makeViews() {
  const auto view = [this](const QString& text, const QString& key, const QString& tip, auto act) {
    QAction* action = make(text, {}, key, tip);
    connect(action, &QAction::triggered, this, act);
    views_.push_back(action);
    return action;
  };
  view(tr("Frame &All"), QStringLiteral("Home"), tr("Bring everything into view."), [this] {
    viewport_.frameAll();
  })->setIcon(Theme::icon(QStringLiteral("frame")));
  view(tr("Frame S&election"), QStringLiteral("F"), tr("Bring what is selected into view."),
       [this] { viewport_.frameSelection(); });
  using Axis = ViewCamera::Axis;
  const auto along = [&](const QString& text, const char* key, Axis axis) {
    view(text, QLatin1String(key), tr("Look along an axis. Also on the number pad."),
         [this, axis] { viewport_.lookAlong(axis); });
  };
  along(tr("&Front"), "1", Axis::front);
  along(tr("Bac&k"), "Ctrl+1", Axis::back);
  along(tr("Ri&ght"), "3", Axis::right);
  along(tr("&Left"), "Ctrl+3", Axis::left);
  along(tr("Top"), "7", Axis::top);
  along(tr("B&ottom"), "Ctrl+7", Axis::bottom);
  orthographic_ = make(tr("Ort&hographic"), {}, QStringLiteral("5"),
                       tr("Without perspective: far things as large as near ones."));
  orthographic_->setCheckable(true);
  connect(orthographic_, &QAction::triggered, &viewport_, &Viewport::setOrthographic);
  connect(&viewport_, &Viewport::cameraChanged, this,
          [this] { orthographic_->setChecked(viewport_.camera().isOrthographic()); });
  statistics_ = make(tr("&Drawing Statistics"), {}, QStringLiteral("F12"), tr("What drawing costs."));
  statistics_->setCheckable(true);
  connect(statistics_, &QAction::triggered, this, [this](bool on) {
    ViewSettings settings = viewport_.viewSettings();
    settings.statistics = on;
    viewport_.setViewSettings(settings);
  });
}

void ViewActions::addTo(QMenu& menu) const {
  for (std::size_t i = 0; i < views_.size(); ++i) {
    if (i == 2) menu.addSeparator();
    menu.addAction(views_[i]);
  }
  menu.addAction(orthographic_);
  menu.addSeparator();
  for (QAction* action : shows_) menu.addAction(action);
  menu.addSeparator();
  menu.addAction(statistics_);
}

void ViewActions::showTool() {
  const auto* transform = dynamic_cast<TransformTool*>(viewport_.tool());
  for (QAction* action : tools_) {
    const bool isSelect = action == tools_.front();
    action->setChecked(isSelect ? viewport_.tool() == nullptr
                                : transform != nullptr &&
                                      action->data().toInt() == static_cast<int>(transform->mode()));
  }
}

void ViewActions::showSettings() {
  const ViewSettings& settings = viewport_.viewSettings();
  for (std::size_t i = 0; i < shows_.size(); ++i) shows_[i]->setChecked(settings.*shown_[i]);
  statistics_->setChecked(settings.statistics);
}

}  // namespace ui
