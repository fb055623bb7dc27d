#include "ui/editors/editor_actions.h"

#include <QAction>
#include <QKeyEvent>
#include <QTimer>

#include "ui/editors/glue_pairs.h"
#include "ui/editors/glue_panel.h"
#include "ui/editors/glue_tool.h"
#include "ui/editors/points_tool.h"
#include "ui/editors/render_dialog.h"
#include "ui/editors/threshold_dialog.h"
#include "ui/kinds/part_kinds.h"
#include "ui/theme/theme.h"
#include "ui/viewport/viewport.h"

namespace ui {

EditorActions::EditorActions(Session& session, Viewport& viewport, QObject* parent)
    : QObject(parent), session_(session), viewport_(viewport), gluing_(new GlueEditing(session, this)) {
  new GluePanel(*gluing_, &viewport_);
  new GluePairs(session_, viewport_);
  editPoints_ = makeAction(QStringLiteral("edit-points"), tr("Edit Points"),
                           tr("Edit the points of the selected part: profile, net or curve (Tab)"),
                           QKeySequence(Qt::Key_Tab));
  // Elsewhere Tab goes from field to field.
  editPoints_->setShortcutContext(Qt::WidgetShortcut);
  viewport_.addAction(editPoints_);
  viewport_.installEventFilter(this);
  glue_ = makeAction(QStringLiteral("glue"), tr("Glue Parts"),
                     tr("Glue two parts: pick them, then see and choose what is joined (Shift+G)"),
                     QKeySequence(Qt::SHIFT | Qt::Key_G));
  tuneThreshold_ = makeAction(QStringLiteral("threshold"), tr("Tune Threshold…"),
                              tr("Find the threshold at which a material breaks well"), {});
  render_ = makeAction(QStringLiteral("film"), tr("Ren&der…"),
                       tr("Draw a ray-traced picture of what is shown, or a film of the take (Ctrl+R)"),
                       QKeySequence(Qt::CTRL | Qt::Key_R));
  connect(render_, &QAction::triggered, this,
          [this] { (new RenderDialog(session_, viewport_, viewport_.window()))->show(); });
  editPoints_->setCheckable(true);
  glue_->setCheckable(true);
  connect(editPoints_, &QAction::triggered, this, &EditorActions::togglePoints);
  connect(glue_, &QAction::triggered, this, &EditorActions::toggleGlue);
  connect(tuneThreshold_, &QAction::triggered, this, [this] {
    const Item current = session_.selection().current();
    openThresholdDialog(current.kind == ItemKind::material ? current.index : 0);
  });
  connect(gluing_, &GlueEditing::changed, this, [this] {
    viewport_.update();
    if (gluing_->stage() == GlueEditing::Stage::off && dynamic_cast<GlueTool*>(viewport_.tool()))
      // The tool may be the one that just said so.
      QTimer::singleShot(0, this, [this] {
        if (gluing_->stage() == GlueEditing::Stage::off && dynamic_cast<GlueTool*>(viewport_.tool()))
          viewport_.setTool(nullptr);
      });
  });
  connect(&viewport_, &Viewport::toolChanged, this, &EditorActions::toolChanged);
  connect(&session_.selection(), &Selection::changed, this, &EditorActions::show);
  connect(&session_.document(), &Document::sceneChanged, this, &EditorActions::show);
  show();
}

/// Keys of the tool are no shortcuts of the window meanwhile.
bool EditorActions::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && dynamic_cast<PointsTool*>(viewport_.tool()) != nullptr) {
    const auto& key = static_cast<const QKeyEvent&>(*event);
    if (PointsTool::takes(key.key(), key.modifiers())) {
      event->accept();
      return true;
    }
  }
  return QObject::eventFilter(watched, event);
}

QAction* EditorActions::makeAction(const QString& icon, const QString& text, const QString& tip,
                                   const QKeySequence& key) {
  auto* action = new QAction(Theme::icon(icon), text, this);
  action->setToolTip(tip);
  action->setShortcut(key);
  return action;
}

const modeling::Part* EditorActions::selectedPart() const {
  const Item current = session_.selection().current();
  const auto& parts = session_.document().scene().parts;
  return current.kind == ItemKind::part && current.index < parts.size() ? &parts[current.index] : nullptr;
}

void EditorActions::togglePoints() {
  if (dynamic_cast<PointsTool*>(viewport_.tool()) != nullptr) return viewport_.setTool(nullptr);
  const modeling::Part* part = selectedPart();
  if (part != nullptr && kindOf(part->shape).editor == ShapeEditor::profile) {
    editPoints_->setChecked(false);
    emit profileWanted();
  } else if (part != nullptr && hasPoints(part->shape)) {
    session_.showEdited();
    viewport_.setTool(std::make_unique<PointsTool>(session_, part->name));
    viewport_.setFocus();  // whose keys are the tool's, Esc among them
  }
}

void EditorActions::toggleGlue(bool on) {
  if (!on) return gluing_->end();
  session_.showEdited();
  viewport_.setTool(std::make_unique<GlueTool>(session_, *gluing_));
  gluing_->begin();
  viewport_.setFocus();
}

void EditorActions::toolChanged() {
  const bool glues = dynamic_cast<GlueTool*>(viewport_.tool()) != nullptr;
  if (!glues) gluing_->end();
  glue_->setChecked(glues);
  editPoints_->setChecked(dynamic_cast<PointsTool*>(viewport_.tool()) != nullptr);
  show();
}

void EditorActions::show() {
  const auto* tool = dynamic_cast<PointsTool*>(viewport_.tool());
  const modeling::Part* part = selectedPart();
  if (tool != nullptr && (part == nullptr || part->name != tool->part())) {
    // Another part is selected: its points are not these.
    QTimer::singleShot(0, this, [this, wanted = tool] {
      if (viewport_.tool() == wanted) viewport_.setTool(nullptr);
    });
  }
  const bool edits = part != nullptr && kindOf(part->shape).editor != ShapeEditor::none;
  editPoints_->setEnabled(edits || tool != nullptr);
  const modeling::Scene& scene = session_.document().scene();
  glue_->setEnabled(scene.parts.size() > 1 || glue_->isChecked());
  tuneThreshold_->setEnabled(!scene.materials.empty());
}

void EditorActions::openThresholdDialog(std::size_t material) {
  if (material >= session_.document().scene().materials.size()) return;
  auto* dialog = new ThresholdDialog(session_, material, viewport_.window());
  dialog->show();
}

}  // namespace ui
