#pragma once

#include <QObject>
#include <deque>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "ui/files/kept_list.h"
#include "ui/session/session.h"

namespace ui {

/// Keeps the takes of scenes that have a file, from one run of the program to the next: they are listed again
/// when the scene is opened. Each scene has a folder of its own in the program's, with the recordings and
/// `takes.json`, which has their names and notes (KeptList).
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
  /// Moves takes that a killed program left into the folder of the scene in that file, where they are not
  /// there yet.
  void receive(const std::vector<LeftTake>& takes, const std::filesystem::path& sceneFile);

 private:
  void follow();
  void load();
  void listNext();
  void chooseNewest();
  void keep();
  void keepRecording(const std::filesystem::path& file);
  void keepPicture(const Take& take);
  void writeIndex();
  void forget(const std::filesystem::path& file);
  bool isListed(const std::filesystem::path& file) const;

  Session& session_;
  std::filesystem::path root_;
  std::filesystem::path sceneFile_;  ///< whose takes are kept; empty: nobody's
  std::filesystem::path folder_;
  std::deque<IndexedTake> waiting_;         ///< in the folder and not yet listed
  std::map<std::string, TakeLabel> known_;  ///< what the index said of each take when it was read or written
  std::set<std::string> removed_;           ///< takes that were taken out since
  bool replaced_ = false;                   ///< the document is another one, not the same under another name
};

}  // namespace ui
