#include "modeling/files/output_file.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include <catch2/catch.hpp>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include "modeling/files/file_stamp.h"
#include "modeling/files/output_guard.h"

namespace {

namespace fs = std::filesystem;

struct Folder {
  fs::path path;
  Folder() {
    std::string name = (fs::temp_directory_path() / "smithereens-files-XXXXXX").string();
    path = ::mkdtemp(name.data());
  }
  ~Folder() {
    std::error_code error;
    fs::remove_all(path, error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  fs::path file(const std::string& name, const std::string& text) const {
    std::ofstream(path / name) << text;
    return path / name;
  }
};

std::string textOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::size_t countIn(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

mode_t modeOf(const fs::path& file) {
  struct stat status {};
  REQUIRE(::stat(file.c_str(), &status) == 0);
  return status.st_mode & 07777U;
}

TEST_CASE("a file is replaced as a whole, keeps its permissions, and nothing is left beside it") {
  const Folder folder;
  const fs::path file = folder.file("a.txt", "old");
  ::chmod(file.c_str(), 0600);
  // What people call such files is theirs.
  folder.file("a.txt.new", "mine");
  folder.file("a.txt.part", "mine too");
  REQUIRE(modeling::replaceFile(file, "new"));
  CHECK(textOf(file) == "new");
  CHECK(modeOf(file) == 0600);
  CHECK(textOf(folder.path / "a.txt.new") == "mine");
  CHECK(textOf(folder.path / "a.txt.part") == "mine too");
  CHECK(countIn(folder.path) == 3);
}

TEST_CASE("an unfinished file leaves what was there") {
  const Folder folder;
  const fs::path file = folder.file("a.txt", "old");
  {
    auto output = modeling::OutputFile::create(file);
    REQUIRE(output);
    std::fputs("half", output->stream());
    CHECK(textOf(file) == "old");
    // Nobody may look into it who might not look into the old one.
    ::chmod(file.c_str(), 0640);
  }
  CHECK(textOf(file) == "old");
  CHECK(countIn(folder.path) == 1);
}

TEST_CASE("a new file has the permissions that the person's mask leaves") {
  const Folder folder;
  const mode_t before = ::umask(027);
  REQUIRE(modeling::replaceFile(folder.path / "a", "text"));
  ::umask(before);
  CHECK(modeOf(folder.path / "a") == 0640);
}

TEST_CASE("attributes, of which access lists are some, stay with a file") {
  const Folder folder;
  const fs::path file = folder.file("a", "old");
  // Not every file system has them.
  if (::setxattr(file.c_str(), "user.origin", "kiln", 4, 0) != 0) return;
  REQUIRE(modeling::replaceFile(file, "new"));
  char value[8] = {};
  CHECK(::getxattr(file.c_str(), "user.origin", value, sizeof value) == 4);
  CHECK(std::string(value) == "kiln");
}

TEST_CASE("a symbolic link stays, and what it leads to is replaced, be it there or not yet") {
  const Folder folder;
  fs::create_directory(folder.path / "far");
  const fs::path target = folder.file("far/target", "old");
  fs::create_symlink("far/target", folder.path / "near");
  fs::create_symlink("near", folder.path / "nearest");
  REQUIRE(modeling::replaceFile(folder.path / "nearest", "new"));
  CHECK(textOf(target) == "new");
  CHECK(fs::is_symlink(folder.path / "near"));
  CHECK(fs::is_symlink(folder.path / "nearest"));
  fs::create_symlink("far/later", folder.path / "dangling");
  REQUIRE(modeling::replaceFile(folder.path / "dangling", "made"));
  CHECK(textOf(folder.path / "far/later") == "made");
  CHECK(fs::is_symlink(folder.path / "dangling"));
  fs::create_symlink("b", folder.path / "a");
  fs::create_symlink("a", folder.path / "b");
  CHECK(modeling::linkTarget(folder.path / "a") == folder.path / "a");
  CHECK_FALSE(modeling::replaceFile(folder.path / "a", "lost"));
  CHECK(fs::is_symlink(folder.path / "a"));
}

TEST_CASE("another name of a file keeps the old content") {
  const Folder folder;
  const fs::path file = folder.file("a", "old");
  fs::create_hard_link(file, folder.path / "b");
  REQUIRE(modeling::replaceFile(file, "new"));
  CHECK(textOf(folder.path / "b") == "old");
}

TEST_CASE("a device is written to and stays one; a folder is refused; a pipe that nobody reads is told of") {
  const Folder folder;
  CHECK(modeling::replaceFile("/dev/null", "text"));
  CHECK(fs::is_character_file("/dev/null"));
  CHECK_FALSE(modeling::replaceFile(folder.path, "text"));
  const fs::path pipe = folder.path / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_FALSE(modeling::replaceFile(pipe, "text"));
  std::string read;
  std::thread reader([&] { read = textOf(pipe); });
  while (!modeling::replaceFile(pipe, "through the pipe")) std::this_thread::yield();
  reader.join();
  CHECK(read == "through the pipe");
  CHECK(fs::is_fifo(pipe));
}

TEST_CASE("what a killed program left is removed when it is old, ours and nobody writes it") {
  const Folder folder;
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours(48);
  fs::path draft;
  {
    auto writing = modeling::OutputFile::create(folder.path / "a.obj");
    REQUIRE(writing);
    draft = writing->draft();
    fs::last_write_time(draft, old);
    modeling::removeLeftDrafts(folder.path);
    CHECK(fs::exists(draft));
  }
  std::ofstream(draft) << "left";
  modeling::removeLeftDrafts(folder.path);
  CHECK(fs::exists(draft));
  fs::last_write_time(draft, old);
  const fs::path mine = folder.file(".smithereens-notes", "mine");
  fs::last_write_time(mine, old);
  modeling::removeLeftDrafts(folder.path);
  CHECK_FALSE(fs::exists(draft));
  CHECK(fs::exists(mine));
}

TEST_CASE("an output replaces no input, by whatever name, nor another output, nor a folder") {
  const Folder folder;
  const fs::path scene = folder.file("a.scene.json", "{}");
  fs::create_symlink(scene, folder.path / "link");
  fs::create_hard_link(scene, folder.path / "twin");
  for (const bool force : {false, true}) {
    for (const fs::path& name : {scene, folder.path / "." / "a.scene.json", folder.path / "link",
                                 folder.path / "twin", folder.path}) {
      modeling::OutputGuard guard(force);
      guard.reads(scene);
      guard.writes(name, modeling::kinds::report);
      CHECK_FALSE(guard.check());
    }
    fs::create_symlink(folder.path / "later", folder.path / "dangling");
    modeling::OutputGuard guard(force);
    guard.writes(folder.path / "later", modeling::kinds::report);
    guard.writes(folder.path / "dangling", modeling::kinds::take);
    CHECK_FALSE(guard.check());
    fs::remove(folder.path / "dangling");
  }
}

TEST_CASE(
    "a file of another kind is replaced only where one says so, an empty one and one of the kind always") {
  const Folder folder;
  const fs::path thesis = folder.file("thesis.txt", "In the beginning");
  const fs::path empty = folder.file("empty", "");
  const fs::path report = folder.file("r.json", R"({"nodes": 1, "bonds": 2, "state_hash": "00"})");
  const auto allowed = [&](const fs::path& file, const modeling::FileKind& kind, bool force) {
    modeling::OutputGuard guard(force);
    guard.writes(file, kind);
    return guard.check().ok();
  };
  for (const modeling::FileKind* kind :
       {&modeling::kinds::take, &modeling::kinds::png, &modeling::kinds::report, &modeling::kinds::csv,
        &modeling::kinds::obj, &modeling::kinds::xyz, &modeling::kinds::log, &modeling::kinds::film}) {
    INFO(kind->name);
    CHECK_FALSE(allowed(thesis, *kind, false));
    CHECK(allowed(thesis, *kind, true));
    CHECK(allowed(empty, *kind, false));
    CHECK(allowed(folder.path / "absent", *kind, false));
  }
  CHECK(allowed(report, modeling::kinds::report, false));
  CHECK_FALSE(allowed(report, modeling::kinds::table, false));
  CHECK_FALSE(allowed(folder.file("s", R"({"smithereens": 1})"), modeling::kinds::report, false));
  CHECK(allowed("/dev/null", modeling::kinds::take, false));
  CHECK_FALSE(allowed("/dev/zero", modeling::kinds::take, true));
}

TEST_CASE("a file that was changed is known by its content, not by its size or time") {
  const Folder folder;
  const fs::path file = folder.file("a", "one");
  const auto stamp = modeling::FileStamp::of(file);
  const auto time = fs::last_write_time(file);
  CHECK(stamp.changeOf(file) == modeling::FileChange::none);
  folder.file("a", "two");
  fs::last_write_time(file, time);
  CHECK(stamp.changeOf(file) == modeling::FileChange::changed);
  folder.file("a", "one");
  CHECK(stamp.changeOf(file) == modeling::FileChange::none);
  fs::rename(file, folder.path / "b");
  CHECK(stamp.changeOf(file) == modeling::FileChange::gone);
  CHECK(modeling::FileStamp().changeOf(file) == modeling::FileChange::none);
  CHECK(modeling::FileStamp().changeOf(folder.path / "b") == modeling::FileChange::changed);
}

}  // namespace
