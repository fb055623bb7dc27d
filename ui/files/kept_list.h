#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "ui/session/take_list.h"

namespace ui {

/// A take in the folder of a scene.
struct IndexedTake {
  std::string file;  ///< its name in the folder
  TakeLabel label;
};

/// `takes.json` in the folder of a scene's takes: their names and notes. Several windows may have the scene
/// open; what each says of its takes is merged, so that none is lost.
class KeptList {
 public:
  explicit KeptList(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The takes in the folder, in the order of the list; behind them those that no list has, under the names
  /// of their files.
  std::vector<IndexedTake> read() const;
  /// Writes the list with `ours` in it. What another window wrote stays, but for what is `removed` or is not
  /// there any more; what it says of one of ours counts where we say the same as we `knew`. A list that
  /// cannot be read is put aside, and is a Problem.
  sim::Status merge(const std::vector<IndexedTake>& ours, const std::map<std::string, TakeLabel>& known,
                    const std::set<std::string>& removed) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace ui
