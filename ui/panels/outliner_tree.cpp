#include "ui/panels/outliner_tree.h"

#include <QDrag>
#include <QDropEvent>
#include <QHeaderView>
#include <QLineEdit>
#include <QMimeData>
#include <QPainter>
#include <QStyledItemDelegate>

#include "ui/theme/theme.h"

namespace ui {
namespace {

constexpr int kKindRole = Qt::UserRole;
constexpr int kIndexRole = Qt::UserRole + 1;
constexpr int kCountRole = Qt::UserRole + 2;
constexpr int kMarkWidth = 24;

/// Kinds that have a row of their own, in the order of the rows; the scene's comes before.
constexpr ItemKind kKinds[] = {ItemKind::part, ItemKind::gluing, ItemKind::collider, ItemKind::material,
                               ItemKind::track};

/// Writes how many there are behind the name of a kind.
class RowDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QSize size = QStyledItemDelegate::sizeHint(option, index);
    size.setHeight(QFontMetrics(option.font).height() + 9);
    return size;
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    QStyledItemDelegate::paint(painter, option, index);
    const QVariant count = index.data(kCountRole);
    if (!count.isValid()) return;
    painter->save();
    painter->setPen(Theme::instance().colours().dimText);
    const QFont number = Theme::numberFont(-1.0);
    const int before =
        QFontMetrics(index.data(Qt::FontRole).value<QFont>()).horizontalAdvance(index.data().toString());
    painter->setFont(number);
    painter->drawText(option.rect.adjusted(before + 16, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
                      QString::number(count.toInt()));
    painter->restore();
  }
};

QString titleOf(ItemKind kind) {
  switch (kind) {
    case ItemKind::scene:
      return OutlinerTree::tr("Scene");
    case ItemKind::part:
      return OutlinerTree::tr("Parts");
    case ItemKind::gluing:
      return OutlinerTree::tr("Glue");
    case ItemKind::collider:
      return OutlinerTree::tr("Colliders");
    case ItemKind::material:
      return OutlinerTree::tr("Materials");
    case ItemKind::track:
      return OutlinerTree::tr("Tracks");
  }
  return {};
}

}  // namespace

OutlinerTree::OutlinerTree(QWidget* parent) : QTreeWidget(parent) {
  setObjectName(QStringLiteral("outliner-tree"));
  setColumnCount(3);
  setHeaderHidden(true);
  header()->setStretchLastSection(false);
  header()->setMinimumSectionSize(kMarkWidth);
  header()->setSectionResizeMode(nameColumn, QHeaderView::Stretch);
  for (const Column column : {eyeColumn, lockColumn}) {
    header()->setSectionResizeMode(column, QHeaderView::Fixed);
    header()->resizeSection(column, kMarkWidth);
  }
  setIndentation(14);
  setIconSize(QSize(16, 16));
  setUniformRowHeights(true);
  setSelectionMode(ExtendedSelection);
  setEditTriggers(NoEditTriggers);
  setExpandsOnDoubleClick(false);
  setDragDropMode(InternalMove);
  setDragEnabled(true);
  setContextMenuPolicy(Qt::CustomContextMenu);
  setItemDelegateForColumn(nameColumn, new RowDelegate(this));
  setFrameShape(NoFrame);
  // Rows that are selected and rows that are not stand equally far in.
  setStyleSheet(QStringLiteral("QTreeWidget::item, QTreeWidget::item:selected { padding: 0; border: 0; }"));
  auto* scene = new QTreeWidgetItem(this);
  scene->setData(0, kKindRole, static_cast<int>(ItemKind::scene));
  scene->setData(0, kIndexRole, 0);
  for (const ItemKind kind : kKinds) {
    auto* group = new QTreeWidgetItem(this);
    group->setText(nameColumn, titleOf(kind));
    group->setData(0, kKindRole, static_cast<int>(kind));
    group->setFlags(Qt::ItemIsEnabled | Qt::ItemIsDropEnabled);  // between its rows
    QFont font = group->font(nameColumn);
    font.setWeight(QFont::DemiBold);
    group->setFont(nameColumn, font);
    group->setExpanded(true);
  }
}

std::optional<Item> OutlinerTree::itemOf(const QTreeWidgetItem* row) {
  if (!row || !row->data(0, kIndexRole).isValid()) return std::nullopt;
  return Item{static_cast<ItemKind>(row->data(0, kKindRole).toInt()),
              static_cast<std::size_t>(row->data(0, kIndexRole).toULongLong())};
}

QTreeWidgetItem* OutlinerTree::groupOf(ItemKind kind) const {
  return topLevelItem(static_cast<int>(kind));
}

QTreeWidgetItem* OutlinerTree::rowOf(const Item& item) const {
  if (item.kind == ItemKind::scene) return topLevelItem(0);
  return groupOf(item.kind)->child(static_cast<int>(item.index));
}

void OutlinerTree::stopTyping(const QTreeWidgetItem& row) {
  if (state() != EditingState || currentItem() != &row) return;
  if (auto* editor = viewport()->findChild<QLineEdit*>())
    closeEditor(editor, QAbstractItemDelegate::RevertModelCache);
}

void OutlinerTree::setCount(ItemKind kind, std::size_t count) {
  QTreeWidgetItem* group = groupOf(kind);
  const int wanted = static_cast<int>(count);
  while (group->childCount() > wanted) delete group->takeChild(group->childCount() - 1);
  while (group->childCount() < wanted) {
    auto* row = new QTreeWidgetItem;
    row->setData(0, kKindRole, static_cast<int>(kind));
    row->setData(0, kIndexRole, group->childCount());
    group->addChild(row);
  }
  if (group->data(0, kCountRole) != wanted) group->setData(0, kCountRole, wanted);
}

void OutlinerTree::mousePressEvent(QMouseEvent* event) {
  // The marks act on their row alone and leave the selection as it is.
  const QModelIndex index = indexAt(event->position().toPoint());
  const bool mark = index.isValid() && index.column() != nameColumn && index.parent().isValid();
  const SelectionMode mode = selectionMode();
  if (mark) setSelectionMode(NoSelection);
  QTreeWidget::mousePressEvent(event);
  setSelectionMode(mode);
}

std::optional<Item> OutlinerTree::dragged() const {
  const QList<QTreeWidgetItem*> rows = selectedItems();
  if (rows.size() != 1) return std::nullopt;
  return itemOf(rows.front());
}

std::optional<std::size_t> OutlinerTree::placeUnder(const QPoint& at, const Item& item) const {
  const QTreeWidgetItem* under = itemAt(at);
  const std::optional<Item> other = itemOf(under);
  if (!other || other->kind != item.kind || item.kind == ItemKind::scene) return std::nullopt;
  const QRect row = visualItemRect(under);
  std::size_t place = at.y() > row.center().y() ? other->index + 1 : other->index;
  if (place > item.index) --place;
  return place;
}

/// The rows follow the scene, not the drag: the tree's own way would take the row away after it.
void OutlinerTree::startDrag(Qt::DropActions) {
  const QList<QTreeWidgetItem*> rows = selectedItems();
  const std::optional<Item> item = dragged();
  if (!item || item->kind == ItemKind::scene) return;
  auto* drag = new QDrag(this);
  drag->setMimeData(mimeData(rows));
  const QRect seen = visualItemRect(rows.front()) & viewport()->rect();
  drag->setPixmap(viewport()->grab(seen));
  drag->setHotSpot({20, seen.height() / 2});
  drag->exec(Qt::MoveAction);
  setState(NoState);
  viewport()->update();
}

void OutlinerTree::dragMoveEvent(QDragMoveEvent* event) {
  // Which paints where it would go.
  QTreeWidget::dragMoveEvent(event);
  const std::optional<Item> item = dragged();
  if (item && placeUnder(event->position().toPoint(), *item)) {
    event->accept();
  } else {
    event->ignore();
  }
}

void OutlinerTree::dropEvent(QDropEvent* event) {
  const std::optional<Item> item = dragged();
  const std::optional<std::size_t> place =
      item ? placeUnder(event->position().toPoint(), *item) : std::nullopt;
  event->accept();
  setState(NoState);
  viewport()->update();
  if (place && *place != item->index) emit moved(*item, *place);
}

}  // namespace ui
