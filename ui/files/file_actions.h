#pragma once

#include <QObject>
#include <filesystem>

#include "ui/files/recent_files.h"
#include "ui/session/session.h"

class QAction;
class QMenu;
class QWidget;

namespace ui {

/// New, open, save: what the File menu does, with the questions it asks.
class FileActions : public QObject {
  Q_OBJECT

 public:
  /// Questions are asked in front of `window`.
  FileActions(Session& session, RecentFiles& recent, QWidget* window);

  /// Adds everything to the menu.
  void addTo(QMenu& menu);
  QAction* newAction() const { return new_; }
  QAction* openAction() const { return open_; }
  QAction* saveAction() const { return save_; }

  /// True: the scene may be given up, because it is saved or the person says so.
  bool mayLeave();
  void newScene();
  /// A scene or a take. What cannot be opened is reported, and nothing is lost.
  void open(const std::filesystem::path& file);
  /// False where it was not saved. A scene that comes with the program is saved elsewhere, where one says.
  bool save();
  bool saveAs();
  /// What the file of the scene holds now, in place of the scene; an edit that can be undone.
  void reload();

  /// Where files are looked for that can be opened by dropping them on the window.
  static bool canOpen(const std::filesystem::path& file);

 signals:
  /// There is a document now.
  void opened();

 private:
  void askWhatToOpen();
  bool saveTo(const std::filesystem::path& file);
  bool saveHere();
  bool saveOverChange(modeling::FileChange change);
  bool keepOther() const;
  void openScene(const std::filesystem::path& file);
  void openTake(const std::filesystem::path& file);
  void tell(const std::vector<sim::Problem>& notes);
  void showFaults(const std::vector<sim::Problem>& faults);
  void showRecent(QMenu& menu);

  Session& session_;
  RecentFiles& recent_;
  QWidget* window_;
  QAction* new_;
  QAction* open_;
  QAction* save_;
  QAction* saveAs_;
  QAction* reload_;
  QAction* saveTake_;
};

}  // namespace ui
