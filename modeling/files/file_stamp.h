#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace modeling {

/// What has become of a file since it was stamped.
enum class FileChange { none, changed, gone };

/// What stood in a file, to tell later whether somebody else has changed it: by content, not by time or size,
/// which may stay the same.
class FileStamp {
 public:
  /// Of no file.
  FileStamp() = default;
  /// Of what is there now; the default where nothing can be read.
  static FileStamp of(const std::filesystem::path& file);
  static FileStamp ofText(std::string_view text);
  /// As text() gave it.
  static FileStamp fromText(std::string text);

  const std::string& text() const { return hash_; }
  /// A file that was not there may appear: that is a change.
  FileChange changeOf(const std::filesystem::path& file) const;

  bool operator==(const FileStamp&) const = default;

 private:
  std::string hash_;  ///< "": of no file
};

}  // namespace modeling
