#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>

#include "sim/base/result.h"

namespace modeling {

/// The file that a path leads to: links are followed, also to where there is nothing yet. The path itself
/// where links go round in a circle.
std::filesystem::path linkTarget(const std::filesystem::path& path);

/// A file of the program's being written: it replaces the one at its path in one step, or leaves it as it
/// was. Everything that the program writes, but for takes, which grow, goes through here.
///
/// - A symbolic link stays, and what it leads to is replaced. Another name of the same file (a hard link)
///   keeps the old content.
/// - Permissions, access lists and, where the system lets us, owner and group stay as they were.
/// - Until then the text stands in a draft beside it, of a name that nothing had before.
/// - When finish() has returned, the disk has it.
/// - A terminal, a pipe or another device is written to and never replaced; so is what standard output or
///   error goes to. What is write-protected is refused.
class OutputFile {
 public:
  /// A Problem that names the path where nothing can be written to it.
  static sim::Result<OutputFile> create(const std::filesystem::path& path);
  OutputFile(OutputFile&& other) noexcept = default;
  OutputFile& operator=(OutputFile&&) = delete;
  /// Unfinished: leaves what was there.
  ~OutputFile();

  /// To write to; never null before finish().
  std::FILE* stream() { return stream_.get(); }
  /// Of programs that write by name; they may empty the file, but not replace it. "" of a device.
  const std::filesystem::path& draft() const { return draft_; }
  /// Puts it in its place. A Problem that names the path when anything could not be written.
  sim::Status finish();

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  explicit OutputFile(std::filesystem::path path) : path_(std::move(path)) {}
  sim::Status openDraft();
  sim::Status openDevice(int descriptor);
  sim::Problem failure(int error) const;

  std::filesystem::path path_;    ///< as it was asked for
  std::filesystem::path target_;  ///< what it leads to
  std::filesystem::path draft_;   ///< "": writes to a device
  std::unique_ptr<std::FILE, Close> stream_;
};

/// Replaces the file, as OutputFile does.
sim::Status replaceFile(const std::filesystem::path& path, std::string_view bytes);

/// Replaces the file by a copy of another.
sim::Status replaceByCopy(const std::filesystem::path& path, const std::filesystem::path& from);

/// Whether replaceFile() would find a place that it can write to. Leaves everything as it is.
sim::Status checkReplaceable(const std::filesystem::path& path);

/// Removes drafts that programs which were killed left in the folder: named as OutputFile names them, ours,
/// written by nobody now, and older than a day.
void removeLeftDrafts(const std::filesystem::path& folder);

}  // namespace modeling
