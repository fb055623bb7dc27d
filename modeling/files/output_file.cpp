#include "modeling/files/output_file.h"

#include <cctype>
#include <cerrno>
#include <cstring>
#include <ctime>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

namespace modeling {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDraftName = ".smithereens-";
constexpr std::size_t kDraftLetters = 10;
/// Nobody writes for a day without a lock; where a file system has none, a day is long enough.
constexpr time_t kLeftAfter = 24 * 60 * 60;

std::string remedyFor(int error) {
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      return "free some room, or choose another disk";
    case EFBIG:
      return "raise the limit on the size of files";
    case EISDIR:
      return "name a file in it";
    case ENXIO:
      return "start what reads it first";
    default:
      return "choose a folder that exists, is yours and has room";
  }
}

std::string draftName(const fs::path& target) {
  static constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789";
  static thread_local std::mt19937_64 random{std::random_device{}()};
  std::string name(kDraftName);
  for (std::size_t i = 0; i < kDraftLetters; ++i) name += kLetters[random() % kLetters.size()];
  return name + target.extension().string();
}

bool isDraftName(std::string_view name) {
  if (!name.starts_with(kDraftName)) return false;
  name.remove_prefix(kDraftName.size());
  if (name.size() < kDraftLetters || (name.size() > kDraftLetters && name[kDraftLetters] != '.'))
    return false;
  for (const char letter : name.substr(0, kDraftLetters)) {
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0) return false;
  }
  return true;
}

/// Access lists are such attributes: without them, the bits of the group would mean another thing.
void copyAttributes(const fs::path& from, int to) {
  std::vector<char> names(64UL * 1024);
  const ssize_t length = ::listxattr(from.c_str(), names.data(), names.size());
  for (ssize_t at = 0; at < length;
       at += static_cast<ssize_t>(std::strlen(&names[static_cast<std::size_t>(at)])) + 1) {
    const char* const name = &names[static_cast<std::size_t>(at)];
    std::vector<char> value(64UL * 1024);
    const ssize_t size = ::getxattr(from.c_str(), name, value.data(), value.size());
    if (size >= 0) static_cast<void>(::fsetxattr(to, name, value.data(), static_cast<std::size_t>(size), 0));
  }
}

/// Whoever might not read the old file may not read the new one.
void copyPermissions(const fs::path& from, const struct stat& old, int to) {
  mode_t mode = old.st_mode & 07777U;
  if (::fchown(to, old.st_uid, old.st_gid) != 0 && ::fchown(to, static_cast<uid_t>(-1), old.st_gid) != 0) {
    // Of another group: it may what all may, and no more.
    mode = (mode & ~mode_t{070}) | ((mode & 07U) << 3U);
  }
  static_cast<void>(::fchmod(to, mode));
  copyAttributes(from, to);
}

void syncFolder(const fs::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  // Some file systems cannot; then nobody can do more.
  static_cast<void>(::fsync(descriptor));
  ::close(descriptor);
}

/// Standard output or error, where it goes to that file; else -1.
int standardDescriptorOf(const struct stat& file) {
  for (const int descriptor : {STDOUT_FILENO, STDERR_FILENO}) {
    struct stat open {};
    if (::fstat(descriptor, &open) == 0 && open.st_dev == file.st_dev && open.st_ino == file.st_ino)
      return descriptor;
  }
  return -1;
}

fs::path folderOf(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

}  // namespace

fs::path linkTarget(const fs::path& path) {
  constexpr int kMostLinks = 40;
  fs::path target = path;
  std::error_code error;
  for (int links = 0; links < kMostLinks; ++links) {
    if (!fs::is_symlink(fs::symlink_status(target, error))) return target;
    const fs::path next = fs::read_symlink(target, error);
    if (error) return path;
    target = next.is_absolute() ? next : folderOf(target) / next;
  }
  return path;
}

sim::Problem OutputFile::failure(int error) const {
  std::string what = "this file cannot be written";
  if (error != 0) what += std::string(": ") + std::strerror(error);
  return {path_.string(), what, remedyFor(error)};
}

sim::Result<OutputFile> OutputFile::create(const fs::path& path) {
  OutputFile file(path);
  struct stat there {};
  const bool exists = ::stat(path.c_str(), &there) == 0;
  if (!exists && errno == ELOOP) return file.failure(ELOOP);
  if (exists && S_ISDIR(there.st_mode)) return file.failure(EISDIR);
  if (exists && S_ISBLK(there.st_mode)) return file.failure(EPERM);
  const int standard = exists ? standardDescriptorOf(there) : -1;
  if (standard >= 0 || (exists && !S_ISREG(there.st_mode))) {
    std::fflush(nullptr);
    // Without blocking, so that a pipe that nobody reads is an error and not a wait for ever.
    const int descriptor =
        standard >= 0 ? ::dup(standard) : ::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (const sim::Status opened = file.openDevice(descriptor); !opened) return opened.problem();
    return file;
  }
  file.target_ = linkTarget(path);
  if (const sim::Status opened = file.openDraft(); !opened) return opened.problem();
  return file;
}

sim::Status OutputFile::openDevice(int descriptor) {
  if (descriptor < 0) return failure(errno);
  const int flags = ::fcntl(descriptor, F_GETFL);
  if (flags >= 0) ::fcntl(descriptor, F_SETFL, flags & ~O_NONBLOCK);
  stream_.reset(::fdopen(descriptor, "wb"));
  return sim::Done{};
}

sim::Status OutputFile::openDraft() {
  struct stat old {};
  const bool replaces = ::stat(target_.c_str(), &old) == 0;
  if (replaces && ::faccessat(AT_FDCWD, target_.c_str(), W_OK, AT_EACCESS) != 0) return failure(errno);
  int descriptor = -1;
  do {
    draft_ = folderOf(target_) / draftName(target_);
    descriptor = ::open(draft_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, replaces ? 0600 : 0666);
  } while (descriptor < 0 && errno == EEXIST);
  if (descriptor < 0) {
    draft_.clear();
    return failure(errno);
  }
  // Tells removeLeftDrafts() of other programs that it is in use.
  static_cast<void>(::flock(descriptor, LOCK_EX | LOCK_NB));
  if (replaces) copyPermissions(target_, old, descriptor);
  stream_.reset(::fdopen(descriptor, "wb"));
  return sim::Done{};
}

OutputFile::~OutputFile() {
  if (!stream_) return;
  stream_.reset();
  if (!draft_.empty()) ::unlink(draft_.c_str());
}

sim::Status OutputFile::finish() {
  errno = 0;
  const bool written = std::ferror(stream_.get()) == 0 && std::fflush(stream_.get()) == 0;
  if (draft_.empty()) {
    stream_.reset();
    return written ? sim::Status(sim::Done{}) : failure(errno);
  }
  const bool kept = written && ::fsync(::fileno(stream_.get())) == 0;
  if (!kept || ::rename(draft_.c_str(), target_.c_str()) != 0) return failure(errno);
  stream_.reset();
  syncFolder(folderOf(target_));
  return sim::Done{};
}

sim::Status replaceFile(const fs::path& path, std::string_view bytes) {
  sim::Result<OutputFile> file = OutputFile::create(path);
  if (!file) return file.problem();
  std::fwrite(bytes.data(), 1, bytes.size(), file->stream());
  return file->finish();
}

sim::Status replaceByCopy(const fs::path& path, const fs::path& from) {
  std::ifstream in(from, std::ios::binary);
  if (!in) return sim::Problem{from.string(), "this file cannot be read", "check its permissions"};
  sim::Result<OutputFile> file = OutputFile::create(path);
  if (!file) return file.problem();
  std::vector<char> piece(1UL << 20U);
  while (in) {
    in.read(piece.data(), static_cast<std::streamsize>(piece.size()));
    std::fwrite(piece.data(), 1, static_cast<std::size_t>(in.gcount()), file->stream());
  }
  if (!in.eof()) return sim::Problem{from.string(), "this file cannot be read to its end", ""};
  return file->finish();
}

sim::Status checkReplaceable(const fs::path& path) {
  struct stat there {};
  // To open a pipe and close it again would end who reads it.
  if (::stat(path.c_str(), &there) == 0 && (S_ISFIFO(there.st_mode) || S_ISCHR(there.st_mode)))
    return sim::Done{};
  const sim::Result<OutputFile> file = OutputFile::create(path);
  return file ? sim::Status(sim::Done{}) : sim::Status(file.problem());
}

void removeLeftDrafts(const fs::path& folder) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder.empty() ? fs::path(".") : folder, error)) {
    if (!isDraftName(entry.path().filename().string())) continue;
    const int descriptor = ::open(entry.path().c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) continue;
    struct stat left {};
    const bool ours = ::fstat(descriptor, &left) == 0 && S_ISREG(left.st_mode) && left.st_uid == ::geteuid();
    const bool old = std::time(nullptr) - left.st_mtime > kLeftAfter;
    if (ours && old && ::flock(descriptor, LOCK_EX | LOCK_NB) == 0) ::unlink(entry.path().c_str());
    ::close(descriptor);
  }
}

}  // namespace modeling
