#pragma once

#include <QObject>
#include <deque>
#include <filesystem>

#include "ui/session/session.h"

namespace ui {

/// Keeps the takes of scenes that have a file, from one run of the program to the next: they are listed again
/// when the scene is opened. Each scene has a folder of its own in the program's, with the recordings and
/// `takes.json`, which has their names and notes.
///
/// A recording is linked into that folder as soon as it is listed, while it is still being written; where the
/// file system has no links it is copied when it is done.
class KeptTakes : public QObject {
  Q_OBJECT

 public:
  /// `root` is where the folders of all scenes are.
  KeptTakes(Session& session, std::filesystem::path root, QObject* parent = nullptr);

  /// Of the scene in that file.
  std::filesystem::path folderOf(const std::filesystem::path& sceneFile) const;

 private:
  /// A take that is in the folder and not yet listed.
  struct Entry {
    std::filesystem::path file;
    TakeLabel label;
  };
  void follow();
  void load();
  void listNext();
  void chooseNewest();
  void keep();
  void keepRecording(const std::filesystem::path& file);
  void writeIndex();
  void forget(const std::filesystem::path& file);
  bool isListed(const std::filesystem::path& file) const;

  Session& session_;
  std::filesystem::path root_;
  std::filesystem::path sceneFile_;  ///< whose takes are kept; empty: nobody's
  std::filesystem::path folder_;
  std::deque<Entry> waiting_;
  QByteArray written_;     ///< what the index says
  bool removed_ = false;   ///< a take was taken out since the index was written
  bool replaced_ = false;  ///< the document is another one, not the same under another name
};

}  // namespace ui
