#pragma once

#include <QDateTime>
#include <QLockFile>
#include <filesystem>
#include <memory>
#include <vector>

#include "modeling/files/file_stamp.h"
#include "modeling/scene/scene.h"
#include "ui/session/take_list.h"

namespace ui {

/// Names of what a program keeps aside in its folder.
inline constexpr const char* kAsideScene = "autosave.scene.json";
inline constexpr const char* kAsideState = "autosave.json";
inline constexpr const char* kAsideLock = "running";

/// Work that a program which was killed left behind. While it is held, no other program takes it up.
struct Leftover {
  std::filesystem::path folder;  ///< of the autosave
  modeling::Scene scene;
  std::filesystem::path file;        ///< where the scene had been saved; empty: nowhere
  std::filesystem::path baseFolder;  ///< where a scene without a file had its own files
  modeling::FileStamp stamp;         ///< what the file held then
  bool modified = true;              ///< the scene is not what its file holds
  std::vector<LeftTake> takes;       ///< of this scene
  QDateTime when;
  QDateTime opened;                  ///< when the scene was
  std::vector<sim::Problem> faults;  ///< what of it is damaged; it is kept, whatever is made of the rest
  bool readable = true;              ///< false: nothing can be made of it
  std::shared_ptr<QLockFile> lock;
};

/// What programs that do not run any more left in `root`, the newest first; each is locked. Folders in which
/// nothing was left are removed.
std::vector<Leftover> leftoversIn(const std::filesystem::path& root);
/// That of one folder; nothing where its program runs, or nothing was left there.
std::vector<Leftover> leftoverOf(const std::filesystem::path& folder);

/// Removes it from the disk.
void discard(const Leftover& leftover);
/// Removes what a program has kept aside, but for the lock, which goes last.
void removeAside(const std::filesystem::path& folder);
/// Moves what is damaged out of the way, where nobody asks about it again, and says where it is.
std::filesystem::path putAside(const Leftover& leftover);

}  // namespace ui
