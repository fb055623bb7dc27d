#pragma once

#include <QWidget>

#include "ui/document/pending_edit.h"
#include "ui/session/session.h"

class QLabel;
class QLineEdit;
class QTreeWidgetItem;

namespace ui {

class OutlinerTree;
class SceneActions;

/// What is in the scene, by kind: selects, renames, hides, locks, orders.
class Outliner : public QWidget, public PendingEdit {
  Q_OBJECT

 public:
  Outliner(Session& session, SceneActions& actions, QWidget* parent = nullptr);

  OutlinerTree& tree() { return *tree_; }
  /// Starts typing a new name for what is selected last.
  void renameSelected();
  void rehearse() override;

 private:
  void showScene();
  void showRow(QTreeWidgetItem& row, const Item& item);
  void showGroup(QTreeWidgetItem& group, ItemKind kind);
  QString problemOf(const Item& item) const;
  void showSelection();
  void takeSelection();
  void takeName(QTreeWidgetItem* row, int column);
  void takeClick(QTreeWidgetItem* row, int column);
  void takeOrder(const Item& item, std::size_t index);
  void openMenu(const QPoint& at);
  void filter();

  Session& session_;
  SceneActions& actions_;
  OutlinerTree* tree_;
  QLineEdit* filter_;
  QLabel* hint_;
  bool showing_ = false;  ///< what changes in the tree comes from the scene, not from a person
};

}  // namespace ui
