#include "sim/take/take_file.h"

#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace sim {
namespace {

std::string remedyFor(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "free some room, or record to another disk";
    case EFBIG:
      return "raise the limit on the size of files, or record less";
    case ENOENT:
      return "check the name and its folder";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a place that may be written to";
    default:
      return "";
  }
}

}  // namespace

Problem TakeFile::failure(const char* what, int error) const {
  return Problem{path_.string(), std::string(what) + ": " + std::strerror(error), remedyFor(error)};
}

TakeFile::TakeFile(TakeFile&& other) noexcept
    : path_(std::move(other.path_)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      regular_(other.regular_),
      torn_(other.torn_),
      size_(other.size_) {}

TakeFile& TakeFile::operator=(TakeFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  std::swap(regular_, other.regular_);
  std::swap(torn_, other.torn_);
  std::swap(size_, other.size_);
  return *this;
}

TakeFile::~TakeFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<TakeFile> TakeFile::open(const std::filesystem::path& path, int flags) {
  // Non-blocking, so that a named pipe given by mistake is an error and not a wait for ever.
  const int descriptor = ::open(path.c_str(), flags | O_CLOEXEC | O_NONBLOCK, 0666);
  TakeFile file(path, descriptor);
  if (descriptor < 0) return file.failure("the take can't be opened", errno);
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) return file.failure("the take can't be opened", errno);
  file.regular_ = S_ISREG(status.st_mode);
  file.size_ = file.regular_ ? static_cast<std::uint64_t>(status.st_size) : 0;
  return file;
}

Status TakeFile::lock() {
  if (!regular_ || ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return Done{};
  // Some network file systems have no locks; recording there is better than not recording.
  if (errno != EWOULDBLOCK) return Done{};
  return Problem{path_.string(), "this take is being recorded by another program",
                 "wait until it is done, stop it, or choose another name"};
}

Result<TakeFile> TakeFile::create(const std::filesystem::path& path) {
  // Emptied only after the lock is had: O_TRUNC would spoil a take that someone is recording.
  auto file = open(path, O_RDWR | O_CREAT | O_APPEND);
  if (!file) return file;
  if (Status locked = file->lock(); !locked) return locked.problem();
  if (Status emptied = file->cut(0); !emptied) return emptied.problem();
  return file;
}

Result<TakeFile> TakeFile::openToAppend(const std::filesystem::path& path) {
  auto file = open(path, O_RDWR | O_APPEND);
  if (!file) return file;
  if (Status locked = file->lock(); !locked) return locked.problem();
  // What the one who held the lock before appended between open and lock.
  struct stat status {};
  if (::fstat(file->descriptor_, &status) == 0 && file->regular_)
    file->size_ = static_cast<std::uint64_t>(status.st_size);
  return file;
}

Result<TakeFile> TakeFile::openToRead(const std::filesystem::path& path) {
  return open(path, O_RDONLY);
}

Status TakeFile::append(std::span<const std::byte> bytes) {
  if (torn_) {
    if (Status mended = cut(size_); !mended) return mended;
  }
  for (std::span<const std::byte> rest = bytes; !rest.empty();) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      const Problem problem = failure("the take can't be written", written < 0 ? errno : ENOSPC);
      torn_ = true;
      (void)cut(size_);  // If even that fails the tail stays torn, and a reader drops it.
      return problem;
    }
    rest = rest.subspan(static_cast<std::size_t>(written));
  }
  size_ += bytes.size();
  return Done{};
}

Status TakeFile::cut(std::uint64_t size) {
  if (regular_ && ::ftruncate(descriptor_, static_cast<off_t>(size)) != 0)
    return failure("the take can't be cut", errno);
  torn_ = false;
  size_ = size;
  return Done{};
}

Status TakeFile::sync() {
  if (!regular_) return Done{};
  if (::fsync(descriptor_) != 0) return failure("the take can't be written to the disk", errno);
  // Its name is the folder's; some file systems cannot be asked for that, and need not be.
  const std::filesystem::path folder = path_.has_parent_path() ? path_.parent_path() : ".";
  const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened < 0) return Done{};
  static_cast<void>(::fsync(opened));
  ::close(opened);
  return Done{};
}

bool TakeFile::read(std::uint64_t offset, std::span<std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t got = ::pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    offset += static_cast<std::uint64_t>(got);
    bytes = bytes.subspan(static_cast<std::size_t>(got));
  }
  return true;
}

}  // namespace sim
