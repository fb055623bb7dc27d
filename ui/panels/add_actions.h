#pragma once

#include <QObject>
#include <filesystem>

#include "ui/kinds/new_things.h"
#include "ui/session/session.h"

class QAction;
class QMenu;

namespace ui {

/// Puts new things into the scene: the add menu, wherever it is opened.
class AddActions : public QObject {
  Q_OBJECT

 public:
  /// The key counts in the whole window.
  AddActions(Session& session, QWidget* window);

  /// Opens the menu under the pointer.
  QAction* openAction() { return open_; }
  void fill(QMenu& menu);
  /// One step of the history; what is new is selected.
  void add(const NewThing& thing);
  /// Asks for the file of a network first.
  void addNetworkFile();
  /// Asks for the file of a mesh first: a part, or an obstacle.
  void addMeshFile(bool obstacle);
  /// By its name.
  static bool isMesh(const std::filesystem::path& file);
  /// Of one that was dropped: whether it is a part or an obstacle.
  void askAboutMesh(const std::filesystem::path& file);

 signals:
  void added(const Item& item);

 private:
  void openMenu();
  void finish(const QString& name, const std::function<Item(modeling::Scene&)>& change);
  void addMeshOf(const QString& file, bool obstacle);

  Session& session_;
  QWidget* window_;
  QAction* open_;
};

/// How many types of bonds the head of a LAMMPS data file announces; 0 where it says nothing of them.
int bondTypesAnnounced(const QString& file);

}  // namespace ui
