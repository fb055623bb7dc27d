#include "ui/panels/scene_actions.h"

#include <QAction>
#include <QMenu>
#include <QWidget>
#include <algorithm>

#include "ui/document/part_boxes.h"
#include "ui/document/scene_edits.h"
#include "ui/theme/theme.h"

namespace ui {

SceneActions::SceneActions(Session& session, QWidget* window) : QObject(window), session_(session) {
  rename_ = action(tr("Rename"), "rename", Qt::Key_F2, tr("Give what is selected another name"));
  duplicate_ = action(tr("Duplicate"), "duplicate", QKeySequence(Qt::CTRL | Qt::Key_D),
                      tr("Put a copy beside what is selected, with the glue between copied parts"));
  remove_ = action(tr("Delete"), "delete", Qt::Key_Delete, tr("Take what is selected out of the scene"));
  remove_->setShortcuts({QKeySequence(Qt::Key_Delete), QKeySequence(Qt::Key_X)});
  hide_ = action(tr("Hide or Show"), "eye-off", Qt::Key_H, tr("Hidden parts are simulated, but not drawn"));
  showAll_ = action(tr("Show All"), "eye", QKeySequence(Qt::ALT | Qt::Key_H), tr("Draw everything again"));
  lock_ = action(tr("Lock or Unlock"), "lock", {}, tr("Clicks in the viewport pass over what is locked"));
  selectAll_ = action(tr("Select All"), "", QKeySequence::SelectAll, tr("Select all parts"));
  deselect_ = action(tr("Select Nothing"), "", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A),
                     tr("Then the properties are those of the scene"));
  window->addActions({rename_, duplicate_, remove_, hide_, showAll_, lock_, selectAll_, deselect_});
  connect(rename_, &QAction::triggered, this, &SceneActions::renameWanted);
  connect(duplicate_, &QAction::triggered, this, &SceneActions::duplicateSelected);
  connect(remove_, &QAction::triggered, this, &SceneActions::removeSelected);
  connect(hide_, &QAction::triggered, this, [this] { toggleHidden(session_.selection().items()); });
  connect(lock_, &QAction::triggered, this, [this] { toggleLocked(session_.selection().items()); });
  connect(showAll_, &QAction::triggered, this, &SceneActions::showAll);
  connect(selectAll_, &QAction::triggered, this, &SceneActions::selectAll);
  connect(deselect_, &QAction::triggered, this, [this] { session_.selection().clear(); });
  connect(&session_.selection(), &Selection::changed, this, &SceneActions::update);
  connect(&session_.document(), &Document::sceneChanged, this, &SceneActions::update);
  update();
}

QAction* SceneActions::action(const QString& text, const char* icon, const QKeySequence& key,
                              const QString& tip) {
  auto* action = new QAction(text, this);
  if (*icon) action->setIcon(Theme::icon(QString::fromLatin1(icon)));
  action->setShortcut(key);
  const QString shortcut = key.toString(QKeySequence::NativeText);
  action->setToolTip(shortcut.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, shortcut));
  action->setStatusTip(tip);
  return action;
}

void SceneActions::fill(QMenu& menu) {
  menu.addActions({rename_, duplicate_, remove_});
  menu.addSeparator();
  menu.addActions({hide_, showAll_, lock_});
  menu.addSeparator();
  menu.addActions({selectAll_, deselect_});
}

void SceneActions::update() {
  const std::vector<Item>& items = session_.selection().items();
  const auto any = [&](auto&& holds) { return std::any_of(items.begin(), items.end(), holds); };
  rename_->setEnabled(!items.empty() && hasName(items.back().kind));
  duplicate_->setEnabled(any([](const Item& item) {
    return item.kind == ItemKind::part || item.kind == ItemKind::collider || item.kind == ItemKind::material;
  }));
  remove_->setEnabled(any([](const Item& item) { return item.kind != ItemKind::scene; }));
  hide_->setEnabled(any([](const Item& item) { return canHide(item.kind); }));
  lock_->setEnabled(any([](const Item& item) { return canLock(item.kind); }));
}

sim::Vec3 SceneActions::offsetOf(const std::vector<Item>& items) const {
  const Eigen::AlignedBox3d box = boxOf(session_.document().scene(), items);
  constexpr double kGap = 2.0;
  return {box.isEmpty() ? 10.0 : box.sizes().x() + kGap, 0.0, 0.0};
}

void SceneActions::duplicateSelected() {
  const std::vector<Item> items = session_.selection().items();
  const sim::Vec3 offset = offsetOf(items);
  std::vector<Item> copies;
  session_.document().edit(tr("Duplicate"),
                           [&](modeling::Scene& scene) { copies = duplicate(scene, items, offset); });
  if (!copies.empty()) session_.selection().set(copies);
}

void SceneActions::removeSelected() {
  const std::vector<Item> items = session_.selection().items();
  if (const auto problem = removalProblem(session_.document().scene(), items))
    return session_.report(*problem);
  session_.selection().clear();
  session_.document().edit(tr("Delete"), [&](modeling::Scene& scene) { remove(scene, items); });
}

void SceneActions::toggleHidden(const std::vector<Item>& items) {
  const modeling::Scene& scene = session_.document().scene();
  const bool hide = std::any_of(items.begin(), items.end(), [&](const Item& item) {
    return canHide(item.kind) && !isHidden(scene, item);
  });
  session_.document().edit(hide ? tr("Hide") : tr("Show"), [&](modeling::Scene& changed) {
    for (const Item& item : items) setHidden(changed, item, hide);
  });
}

void SceneActions::toggleLocked(const std::vector<Item>& items) {
  const modeling::Scene& scene = session_.document().scene();
  const bool lock = std::any_of(items.begin(), items.end(), [&](const Item& item) {
    return canLock(item.kind) && !isLocked(scene, item);
  });
  session_.document().edit(lock ? tr("Lock") : tr("Unlock"), [&](modeling::Scene& changed) {
    for (const Item& item : items) setLocked(changed, item, lock);
  });
}

void SceneActions::showAll() {
  session_.document().edit(tr("Show All"), [](modeling::Scene& scene) {
    scene.view.hidden.clear();
    for (modeling::SceneCollider& collider : scene.environment.colliders) collider.visible = true;
  });
}

void SceneActions::selectAll() {
  std::vector<Item> items;
  for (std::size_t i = 0; i < session_.document().scene().parts.size(); ++i)
    items.push_back({ItemKind::part, i});
  session_.selection().set(std::move(items));
}

}  // namespace ui
