#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "modeling/files/file_kind.h"
#include "sim/base/result.h"

namespace modeling {

/// A file that something is about to write.
struct PlannedFile {
  std::filesystem::path path;
  const FileKind* kind = nullptr;
  bool isOneOfMany = false;  ///< what is named after one name cannot go to a pipe or a terminal
};

/// What a command reads and writes, to see before it begins that it spoils nothing.
///
/// An output never replaces what is read, by whatever name (another path, a link, a hard link), nor another
/// output, a folder or a device; nor a file that is not of its kind, unless `force`. What is empty or is not
/// there may be written, and what is of its kind is replaced.
class OutputGuard {
 public:
  OutputGuard() = default;
  /// Of a command, which has an option --force.
  explicit OutputGuard(bool force) : force_(force), canForce_(true) {}

  void reads(const std::filesystem::path& file) { inputs_.push_back(file); }
  void reads(const std::vector<std::filesystem::path>& files) {
    inputs_.insert(inputs_.end(), files.begin(), files.end());
  }
  /// "" is not written.
  void writes(const std::filesystem::path& file, const FileKind& kind) {
    if (!file.empty()) outputs_.push_back({file, &kind, false});
  }
  /// All that is made under one name.
  void writes(const std::vector<PlannedFile>& files) {
    for (const PlannedFile& file : files) outputs_.push_back({file.path, file.kind, files.size() > 1});
  }

  /// The first Problem there is; it names the output. Drafts that killed programs left beside outputs are
  /// removed where there is none.
  sim::Status check() const;

 private:
  sim::Status checkOne(const PlannedFile& output) const;

  bool force_ = false;
  bool canForce_ = false;
  std::vector<std::filesystem::path> inputs_;
  std::vector<PlannedFile> outputs_;
};

}  // namespace modeling
