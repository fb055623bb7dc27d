#pragma once

#include <QObject>
#include <vector>

#include "ui/session/session.h"

class QAction;
class QMenu;

namespace ui {

/// What can be done to the selected things, from menus, keys and panels alike.
class SceneActions : public QObject {
  Q_OBJECT

 public:
  /// The keys count in the whole window.
  SceneActions(Session& session, QWidget* window);

  Session& session() { return session_; }
  QAction* renameAction() { return rename_; }
  QAction* duplicateAction() { return duplicate_; }
  QAction* removeAction() { return remove_; }
  QAction* hideAction() { return hide_; }
  QAction* showAllAction() { return showAll_; }
  QAction* lockAction() { return lock_; }
  QAction* selectAllAction() { return selectAll_; }
  QAction* deselectAction() { return deselect_; }
  /// For a context menu or the menu bar.
  void fill(QMenu& menu);

  void duplicateSelected();
  void removeSelected();
  void toggleHidden(const std::vector<Item>& items);
  void toggleLocked(const std::vector<Item>& items);

 signals:
  /// Somebody asked to type a new name for what is selected last.
  void renameWanted();

 private:
  QAction* action(const QString& text, const char* icon, const QKeySequence& key, const QString& tip);
  void selectAll();
  void showAll();
  void update();
  /// To the right by its own width and a little.
  sim::Vec3 offsetOf(const std::vector<Item>& items) const;

  Session& session_;
  QAction* rename_ = nullptr;
  QAction* duplicate_ = nullptr;
  QAction* remove_ = nullptr;
  QAction* hide_ = nullptr;
  QAction* showAll_ = nullptr;
  QAction* lock_ = nullptr;
  QAction* selectAll_ = nullptr;
  QAction* deselect_ = nullptr;
};

}  // namespace ui
