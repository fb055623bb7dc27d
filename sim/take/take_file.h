#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>

#include "sim/base/result.h"

namespace sim {

/// A file that grows at its end only. An append is whole or leaves the file as it was; a kill in the middle
/// of one leaves a torn tail, never a hole. Reading is thread-safe; appending and cutting are not.
class TakeFile {
 public:
  /// Creates the file, or empties it. A Problem when another process is appending to it.
  static Result<TakeFile> create(const std::filesystem::path& path);
  /// Opens an existing file to append. A Problem when another process is appending to it.
  static Result<TakeFile> openToAppend(const std::filesystem::path& path);
  static Result<TakeFile> openToRead(const std::filesystem::path& path);

  TakeFile(TakeFile&& other) noexcept;
  TakeFile& operator=(TakeFile&& other) noexcept;
  TakeFile(const TakeFile&) = delete;
  TakeFile& operator=(const TakeFile&) = delete;
  ~TakeFile();

  const std::filesystem::path& path() const { return path_; }
  /// As it was when opened, and what was appended and cut here since; another's appends don't show.
  std::uint64_t size() const { return size_; }

  /// All bytes or nothing: on a full disk what was written of them is cut off again.
  Status append(std::span<const std::byte> bytes);
  /// Cuts off what stands behind the first `size` bytes.
  Status cut(std::uint64_t size);
  /// Returns when the disk has everything.
  Status sync();
  /// Fills `bytes` from `offset` on. False when the file ends before or can't be read.
  bool read(std::uint64_t offset, std::span<std::byte> bytes) const;

 private:
  TakeFile(std::filesystem::path path, int descriptor) : path_(std::move(path)), descriptor_(descriptor) {}
  static Result<TakeFile> open(const std::filesystem::path& path, int flags);
  Status lock();
  Problem failure(const char* what, int error) const;

  std::filesystem::path path_;
  int descriptor_ = -1;
  bool regular_ = true;  ///< false for /dev/null and the like, which can be neither locked nor cut
  bool torn_ = false;    ///< bytes of a failed append may still stand behind size_
  std::uint64_t size_ = 0;
};

}  // namespace sim
