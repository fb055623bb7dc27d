#include "ui/panels/outliner.h"

#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <set>

#include "ui/document/scene_edits.h"
#include "ui/panels/item_icons.h"
#include "ui/panels/outliner_tree.h"
#include "ui/panels/scene_actions.h"
#include "ui/theme/theme.h"

namespace ui {
namespace {

constexpr ItemKind kKinds[] = {ItemKind::part, ItemKind::gluing, ItemKind::collider, ItemKind::material,
                               ItemKind::track};

}  // namespace

Outliner::Outliner(Session& session, SceneActions& actions, QWidget* parent)
    : QWidget(parent), session_(session), actions_(actions) {
  setObjectName(QStringLiteral("outliner"));
  tree_ = new OutlinerTree(this);
  filter_ = new QLineEdit(this);
  filter_->setPlaceholderText(tr("Filter"));
  filter_->setToolTip(tr("Show only names that contain this"));
  filter_->setClearButtonEnabled(true);
  filter_->addAction(Theme::icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  hint_ = new QLabel(tr("Nothing here yet. Press Shift+A to add a cup."), this);
  hint_->setWordWrap(true);
  hint_->setAlignment(Qt::AlignCenter);
  hint_->setContentsMargins(12, 12, 12, 12);
  hint_->setForegroundRole(QPalette::PlaceholderText);
  // On the ground of the list above.
  hint_->setBackgroundRole(QPalette::AlternateBase);
  hint_->setAutoFillBackground(true);
  auto* bar = new QHBoxLayout;
  bar->setContentsMargins(6, 6, 6, 4);
  bar->addWidget(filter_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addLayout(bar);
  column->addWidget(tree_, 1);
  column->addWidget(hint_);
  connect(filter_, &QLineEdit::textChanged, this, &Outliner::filter);
  connect(tree_, &QTreeWidget::itemSelectionChanged, this, &Outliner::takeSelection);
  connect(tree_, &QTreeWidget::itemChanged, this, &Outliner::takeName);
  connect(tree_, &QTreeWidget::itemClicked, this, &Outliner::takeClick);
  connect(tree_, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem* row, int clicked) {
    if (clicked != OutlinerTree::nameColumn) return;
    if (OutlinerTree::itemOf(row)) return renameSelected();
    row->setExpanded(!row->isExpanded());
  });
  connect(tree_, &OutlinerTree::moved, this, &Outliner::takeOrder);
  connect(tree_, &QWidget::customContextMenuRequested, this, &Outliner::openMenu);
  connect(&actions_, &SceneActions::renameWanted, this, &Outliner::renameSelected);
  connect(&session_.document(), &Document::sceneChanged, this, &Outliner::showScene);
  // A scene without a name has that of its file.
  connect(&session_.document(), &Document::statusChanged, this, [this] {
    showing_ = true;
    showRow(*tree_->rowOf({}), {});
    showing_ = false;
  });
  connect(&session_, &Session::previewChanged, this, &Outliner::showScene);
  connect(&session_.selection(), &Selection::changed, this, &Outliner::showSelection);
  connect(&Theme::instance(), &Theme::changed, this, &Outliner::showScene);
  showScene();
}

void Outliner::showScene() {
  showing_ = true;
  const modeling::Scene& scene = session_.document().scene();
  showRow(*tree_->rowOf({}), {});
  for (const ItemKind kind : kKinds) {
    tree_->setCount(kind, countOf(scene, kind));
    for (std::size_t i = 0; i < countOf(scene, kind); ++i) showRow(*tree_->rowOf({kind, i}), {kind, i});
  }
  hint_->setVisible(scene.parts.empty());
  filter();
  showing_ = false;
  showSelection();
}

void Outliner::showRow(QTreeWidgetItem& row, const Item& item) {
  const modeling::Scene& scene = session_.document().scene();
  const Colours& colours = Theme::instance().colours();
  const QString name = item.kind == ItemKind::scene ? session_.document().title() : nameOf(scene, item);
  Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
  if (hasName(item.kind)) flags |= Qt::ItemIsEditable;
  if (item.kind != ItemKind::scene) flags |= Qt::ItemIsDragEnabled;
  row.setFlags(flags);
  // A name that is being typed was meant for what stood here.
  if (row.text(OutlinerTree::nameColumn) != name) tree_->stopTyping(row);
  row.setText(OutlinerTree::nameColumn, name);
  row.setIcon(OutlinerTree::nameColumn, iconOf(scene, item));
  const bool hidden = ui::isHidden(scene, item);
  const QString problem = problemOf(item);
  row.setForeground(OutlinerTree::nameColumn, !problem.isEmpty() ? colours.bad
                                              : hidden           ? colours.dimText
                                                                 : colours.text);
  row.setToolTip(OutlinerTree::nameColumn, problem);
  if (canHide(item.kind)) {
    row.setIcon(OutlinerTree::eyeColumn, quietIcon(hidden ? "eye-off" : "eye", !hidden));
    row.setToolTip(OutlinerTree::eyeColumn, hidden ? tr("Show (H)") : tr("Hide: simulated all the same (H)"));
  }
  if (canLock(item.kind)) {
    const bool locked = ui::isLocked(scene, item);
    row.setIcon(OutlinerTree::lockColumn, quietIcon(locked ? "lock" : "unlock", !locked));
    row.setToolTip(OutlinerTree::lockColumn,
                   locked ? tr("Unlock") : tr("Lock: clicks in the viewport pass over it"));
  }
}

/// Of a gluing that could not be made as the scene is now; empty for all else.
QString Outliner::problemOf(const Item& item) const {
  if (item.kind != ItemKind::gluing || session_.preview()->scene.glue != session_.document().scene().glue)
    return {};
  for (const Preview::FailedGluing& failed : session_.preview()->failedGluings)
    if (failed.gluing == item.index) return QString::fromStdString(failed.problem.line());
  return {};
}

void Outliner::showSelection() {
  if (showing_) return;
  std::set<QTreeWidgetItem*> wanted;
  for (const Item& item : session_.selection().items()) wanted.insert(tree_->rowOf(item));
  const QList<QTreeWidgetItem*> present = tree_->selectedItems();
  // What is selected already stays as it is, scrolled to wherever the person has it.
  if (wanted == std::set<QTreeWidgetItem*>(present.begin(), present.end())) return;
  showing_ = true;
  tree_->clearSelection();
  for (const Item& item : session_.selection().items()) {
    QTreeWidgetItem* row = tree_->rowOf(item);
    if (!row) continue;
    row->setSelected(true);
    tree_->setCurrentItem(row, OutlinerTree::nameColumn, QItemSelectionModel::NoUpdate);
    tree_->scrollToItem(row);
  }
  showing_ = false;
}

void Outliner::takeSelection() {
  if (showing_) return;
  std::vector<Item> chosen;
  for (const QTreeWidgetItem* row : tree_->selectedItems()) {
    if (const std::optional<Item> item = OutlinerTree::itemOf(row)) chosen.push_back(*item);
  }
  // What was selected before keeps its place; what the person pointed at last comes last.
  std::vector<Item> items;
  const auto has = [](const std::vector<Item>& list, const Item& item) {
    return std::find(list.begin(), list.end(), item) != list.end();
  };
  for (const Item& item : session_.selection().items()) {
    if (has(chosen, item)) items.push_back(item);
  }
  for (const Item& item : chosen) {
    if (!has(items, item)) items.push_back(item);
  }
  const std::optional<Item> current = OutlinerTree::itemOf(tree_->currentItem());
  if (current && has(items, *current)) {
    std::erase(items, *current);
    items.push_back(*current);
  }
  showing_ = true;
  session_.selection().set(std::move(items));
  showing_ = false;
}

void Outliner::takeName(QTreeWidgetItem* row, int column) {
  const std::optional<Item> item = OutlinerTree::itemOf(row);
  if (showing_ || !item || column != OutlinerTree::nameColumn) return;
  const std::string name = row->text(column).trimmed().toStdString();
  session_.document().edit(tr("Rename"), [&](modeling::Scene& scene) { rename(scene, *item, name); });
  // An empty name or one that is taken became another.
  showing_ = true;
  showRow(*row, *item);
  showing_ = false;
}

/// The name that is being typed into a row.
void Outliner::rehearse() {
  const std::optional<Item> item = OutlinerTree::itemOf(tree_->currentItem());
  const auto* editor = tree_->viewport()->findChild<QLineEdit*>();
  if (!item || editor == nullptr || !editor->isVisible() || !editor->isModified()) return;
  const std::string name = editor->text().trimmed().toStdString();
  session_.document().edit(tr("Rename"), [&](modeling::Scene& scene) { rename(scene, *item, name); });
}

void Outliner::takeClick(QTreeWidgetItem* row, int column) {
  const std::optional<Item> item = OutlinerTree::itemOf(row);
  if (!item || column == OutlinerTree::nameColumn) return;
  // A click on the mark of something selected counts for all that is selected.
  const Selection& selection = session_.selection();
  const std::vector<Item> items = selection.contains(*item) ? selection.items() : std::vector<Item>{*item};
  if (column == OutlinerTree::eyeColumn) actions_.toggleHidden(items);
  if (column == OutlinerTree::lockColumn) actions_.toggleLocked(items);
}

void Outliner::takeOrder(const Item& item, std::size_t index) {
  session_.document().edit(tr("Reorder"), [&](modeling::Scene& scene) { reorder(scene, item, index); });
  session_.selection().select({item.kind, index});
}

void Outliner::renameSelected() {
  const std::vector<Item>& items = session_.selection().items();
  if (items.empty() || !hasName(items.back().kind)) return;
  QTreeWidgetItem* row = tree_->rowOf(items.back());
  if (!row) return;
  tree_->setFocus();
  tree_->editItem(row, OutlinerTree::nameColumn);
}

void Outliner::openMenu(const QPoint& at) {
  QMenu menu(this);
  actions_.fill(menu);
  menu.exec(tree_->viewport()->mapToGlobal(at));
}

void Outliner::filter() {
  const QString wanted = filter_->text().trimmed();
  for (const ItemKind kind : kKinds) {
    QTreeWidgetItem* group = tree_->groupOf(kind);
    bool any = false;
    for (int i = 0; i < group->childCount(); ++i) {
      const bool fits = group->child(i)->text(0).contains(wanted, Qt::CaseInsensitive);
      group->child(i)->setHidden(!fits);
      any |= fits;
    }
    group->setHidden(!wanted.isEmpty() && !any);
  }
}

}  // namespace ui
