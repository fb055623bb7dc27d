#pragma once

#include <QTreeWidget>
#include <optional>

#include "ui/document/selection.h"

namespace ui {

/// The tree of the outliner: a row for the scene, a row for each kind, and under it one for each thing.
class OutlinerTree : public QTreeWidget {
  Q_OBJECT

 public:
  enum Column { nameColumn, eyeColumn, lockColumn };

  explicit OutlinerTree(QWidget* parent = nullptr);

  /// What a row stands for; nothing for the row of a kind.
  static std::optional<Item> itemOf(const QTreeWidgetItem* row);
  QTreeWidgetItem* rowOf(const Item& item) const;
  QTreeWidgetItem* groupOf(ItemKind kind) const;
  /// Drops a name that is being typed in the row.
  void stopTyping(const QTreeWidgetItem& row);
  /// As many rows as there are things.
  void setCount(ItemKind kind, std::size_t count);

 signals:
  /// A row was dragged to another place among its like.
  void moved(const Item& item, std::size_t index);

 protected:
  void dropEvent(QDropEvent* event) override;
  void startDrag(Qt::DropActions actions) override;
  void dragMoveEvent(QDragMoveEvent* event) override;
  Qt::DropActions supportedDropActions() const override { return Qt::CopyAction | Qt::MoveAction; }
  void mousePressEvent(QMouseEvent* event) override;

 private:
  /// The kind whose single row is dragged.
  std::optional<Item> dragged() const;
  std::optional<std::size_t> placeUnder(const QPoint& at, const Item& item) const;
};

}  // namespace ui
