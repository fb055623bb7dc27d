#pragma once

#include <QFileSystemWatcher>
#include <QObject>
#include <QTimer>
#include <filesystem>

#include "ui/session/session.h"

namespace ui {

/// Notices, while a scene is open, that somebody else changes, deletes or renames its file, and says so once
/// for each change. Nothing else happens: saving asks (FileActions).
class OpenedFile : public QObject {
  Q_OBJECT

 public:
  explicit OpenedFile(Session& session, QObject* parent = nullptr);

 private:
  void follow();
  void watch();
  void look();

  Session& session_;
  QFileSystemWatcher watcher_;
  QTimer settled_;  ///< who writes a file touches it several times
  std::filesystem::path file_;
  modeling::FileStamp told_;  ///< what the file held when it was last spoken of
  bool toldGone_ = false;
};

/// What others changed in the file of the document, in the words of the window.
QString changeInWords(const Document& document);

}  // namespace ui
