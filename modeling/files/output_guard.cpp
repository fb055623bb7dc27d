#include "modeling/files/output_guard.h"

#include <cerrno>
#include <map>
#include <set>
#include <utility>

#include <sys/stat.h>
#include <unistd.h>

#include "modeling/files/output_file.h"

namespace modeling {
namespace {

namespace fs = std::filesystem;

using Identity = std::pair<dev_t, ino_t>;

Identity identityOf(const struct stat& file) {
  return {file.st_dev, file.st_ino};
}

bool isStandardOutput(const struct stat& file) {
  struct stat open {};
  return (::fstat(STDOUT_FILENO, &open) == 0 && identityOf(open) == identityOf(file)) ||
         (::fstat(STDERR_FILENO, &open) == 0 && identityOf(open) == identityOf(file));
}

bool isNull(const struct stat& file) {
  struct stat null {};
  return S_ISCHR(file.st_mode) && ::stat("/dev/null", &null) == 0 && null.st_rdev == file.st_rdev;
}

/// Of what is there or not yet: one name for all paths that lead to it.
fs::path oneName(const fs::path& path) {
  std::error_code error;
  const fs::path target = fs::weakly_canonical(fs::absolute(linkTarget(path)), error);
  return error ? path : target;
}

}  // namespace

sim::Status OutputGuard::checkOne(const PlannedFile& output) const {
  const std::string place = output.path.string();
  const std::string name = output.kind->name;
  struct stat there {};
  if (::stat(output.path.c_str(), &there) != 0) {
    if (errno == ELOOP) return sim::Problem{place, "these links go round in a circle", "name a file"};
    if (errno != ENOTDIR) return sim::Done{};
    return sim::Problem{place, "this cannot be: what should be its folder is a file",
                        "choose another folder"};
  }
  if (S_ISDIR(there.st_mode)) return sim::Problem{place, "this is a folder", "name a file in it"};
  for (const fs::path& input : inputs_) {
    struct stat read {};
    if (::stat(input.c_str(), &read) == 0 && identityOf(read) == identityOf(there))
      return sim::Problem{place, "this is " + input.string() + ", which is read: it would be lost",
                          "name another file"};
  }
  const bool device = !S_ISREG(there.st_mode);
  const bool needsFile = output.isOneOfMany || output.kind->grows;
  const bool nowhere = isNull(there) && !output.isOneOfMany;
  if (S_ISBLK(there.st_mode) || (needsFile && !nowhere && (device || isStandardOutput(there))))
    return sim::Problem{place, name + " cannot be written to this", "name a file"};
  if (device || force_ || isStandardOutput(there) || isOfKind(output.path, *output.kind)) return sim::Done{};
  return sim::Problem{place, "there is a file that is not " + name + ": it would be lost",
                      canForce_ ? "name another file, move that one away, or replace it with --force"
                                : "name another file, or move that one away"};
}

sim::Status OutputGuard::check() const {
  std::map<fs::path, fs::path> planned;
  std::map<Identity, fs::path> present;
  std::set<fs::path> folders;
  for (const PlannedFile& output : outputs_) {
    const auto twice = [&](const fs::path& other) {
      return sim::Problem{output.path.string(), "this would be written twice, once as " + other.string(),
                          "name two files"};
    };
    const auto [one, fresh] = planned.try_emplace(oneName(output.path), output.path);
    struct stat there {};
    const bool file = ::stat(output.path.c_str(), &there) == 0 && S_ISREG(there.st_mode);
    // Several texts may go to one terminal.
    if (!fresh && (file || !fs::exists(one->first))) return twice(one->second);
    if (file) {
      const auto [same, isNew] = present.try_emplace(identityOf(there), output.path);
      if (!isNew) return twice(same->second);
    }
    if (const sim::Status good = checkOne(output); !good) return good;
    folders.insert(one->first.parent_path());
  }
  for (const fs::path& folder : folders) removeLeftDrafts(folder);
  return sim::Done{};
}

}  // namespace modeling
