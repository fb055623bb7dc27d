#include "tests/habits/habits.h"

#include <fstream>

#include <catch2/catch.hpp>
#include <unistd.h>

namespace {

using habits::File;
using habits::Offence;
using Tree = std::vector<File>;

constexpr std::size_t kMostLines = 600;

const Tree& ourTree() {
  static const Tree tree = habits::readTree(SMITHEREENS_SOURCE_DIR);
  return tree;
}

void checkNone(const std::vector<Offence>& offences) {
  for (const Offence& offence : offences) FAIL_CHECK(offence.text());
}

/// A tree of one file of one line.
Tree treeOf(const std::string& path, const std::string& line) {
  return {File{path, {line}, false}};
}

TEST_CASE("the tree was found and read") {
  const auto isThisFile = [](const File& file) { return file.path == "tests/habits/habits_test.cpp"; };
  const auto found = std::find_if(ourTree().begin(), ourTree().end(), isThisFile);
  REQUIRE(found != ourTree().end());
  CHECK(found->lines.front() == "#include \"tests/habits/habits.h\"");
}

TEST_CASE("the top-level folders are the architecture's") {
  checkNone(habits::strayFolders(ourTree()));
  CHECK(habits::strayFolders(treeOf("util/misc.cpp", "")).size() == 1);
  CHECK(habits::strayFolders(treeOf("README.md", "")).empty());
}

TEST_CASE("rooms include along the arrows only") {
  checkNone(habits::includesAgainstTheArrows(ourTree()));
  const auto offencesOf = [](const std::string& path, const std::string& line) {
    return habits::includesAgainstTheArrows(treeOf(path, line)).size();
  };
  CHECK(offencesOf("sim/a.h", "#include \"modeling/b.h\"") == 1);
  CHECK(offencesOf("modeling/a.cpp", "#  include <ui/b.h>") == 1);
  CHECK(offencesOf("ui/a.cpp", "#include \"app/b.h\"") == 1);
  CHECK(offencesOf("app/a.cpp", "#include \"tests/b.h\"") == 1);
  CHECK(offencesOf("sim/base/a.cpp", "#include \"../b.h\"") == 1);
  CHECK(offencesOf("ui/a.cpp", "#include \"sim/b.h\"") == 0);
  CHECK(offencesOf("tests/sim/a.cpp", "#include \"app/b.h\"") == 0);
}

TEST_CASE("no room uses a library that is not its own") {
  checkNone(habits::librariesInTheWrongRoom(ourTree()));
  const auto offencesOf = [](const std::string& path, const std::string& line) {
    return habits::librariesInTheWrongRoom(treeOf(path, line)).size();
  };
  CHECK(offencesOf("sim/a.cpp", "#include <QVector>") == 1);
  CHECK(offencesOf("modeling/a.h", "#include <QtCore/QString>") == 1);
  CHECK(offencesOf("sim/a.cpp", "#include <nlohmann/json.hpp>") == 1);
  CHECK(offencesOf("sim/a.cpp", "#include <CLI/CLI.hpp>") == 1);
  CHECK(offencesOf("modeling/a.cpp", "#include <nlohmann/json.hpp>") == 0);
  CHECK(offencesOf("ui/a.cpp", "#include <QWidget>") == 0);
  CHECK(offencesOf("sim/a.cpp", "#include <Eigen/QR>") == 0);
}

TEST_CASE("there is one way to run a loop in parallel") {
  checkNone(habits::parallelLoopsOfTheirOwn(ourTree()));
  const std::string line = "#include <tbb/parallel_reduce.h>";
  CHECK(habits::parallelLoopsOfTheirOwn(treeOf("sim/dynamics/a.cpp", line)).size() == 1);
  CHECK(habits::parallelLoopsOfTheirOwn(treeOf("sim/base/parallel.h", line)).empty());
}

TEST_CASE("nobody leaves notes to himself") {
  checkNone(habits::notesToSelf(ourTree()));
  const std::string note = std::string("TO") + "DO";
  CHECK(habits::notesToSelf(treeOf("sim/a.cpp", "  // " + note + ": think")).size() == 1);
  CHECK(habits::notesToSelf(treeOf("docs/a.md", note)).size() == 1);
  CHECK(habits::notesToSelf(treeOf("sim/a.cpp", "int s" + note + "S;")).empty());
}

TEST_CASE("files fit a head") {
  checkNone(habits::longFiles(ourTree(), kMostLines));
  const Tree tree = {File{"sim/a.cpp", std::vector<std::string>(kMostLines + 1), false},
                     File{"LICENSE", std::vector<std::string>(kMostLines + 1), false},
                     File{"ui/b.cpp", std::vector<std::string>(kMostLines), false}};
  const auto offences = habits::longFiles(tree, kMostLines);
  REQUIRE(offences.size() == 1);
  CHECK(offences.front().file == "sim/a.cpp");
}

TEST_CASE("the scripts run") {
  checkNone(habits::scriptsThatDoNotRun(ourTree()));
  const Tree whole = {File{".ci/run", {}, true}, File{"app/run", {"#!/bin/sh"}, true},
                      File{"tests/run", {"#!/bin/sh"}, true}};
  CHECK(habits::scriptsThatDoNotRun(whole).empty());
  Tree forbidden = whole;
  forbidden[1].executable = false;
  CHECK(habits::scriptsThatDoNotRun(forbidden).size() == 1);
  CHECK(habits::scriptsThatDoNotRun({}).size() == 3);
}

TEST_CASE("headers are read once") {
  checkNone(habits::headersWithoutGuard(ourTree()));
  CHECK(habits::headersWithoutGuard(treeOf("sim/a.h", "int a();")).size() == 1);
}

TEST_CASE("every source is built") {
  checkNone(habits::sourcesNobodyBuilds(ourTree()));
  const Tree tree = {File{"sim/base/a.cpp", {}, false}, File{"sim/base/b.cpp", {}, false},
                     File{"sim/CMakeLists.txt", {"  base/a.cpp"}, false}};
  const auto offences = habits::sourcesNobodyBuilds(tree);
  REQUIRE(offences.size() == 1);
  CHECK(offences.front().file == "sim/base/b.cpp");
}

TEST_CASE("reading a tree leaves out what is made, and sees what may be executed") {
  namespace fs = std::filesystem;
  const fs::path root = fs::temp_directory_path() / ("smithereens-habits-" + std::to_string(::getpid()));
  const auto write = [&](const std::string& path) {
    fs::create_directories((root / path).parent_path());
    std::ofstream(root / path) << "#!/bin/sh\nexit\n";
  };
  for (const auto* const path : {"sim/a.cpp", "build/b.cpp", ".git/c", ".ci/run", "resources/data.obj"})
    write(path);
  fs::permissions(root / ".ci/run", fs::perms::owner_exec, fs::perm_options::add);

  const Tree tree = habits::readTree(root);
  fs::remove_all(root);
  REQUIRE(tree.size() == 3);
  CHECK(tree[0].path == ".ci/run");
  CHECK(tree[0].executable);
  CHECK(tree[1].path == "resources/data.obj");
  CHECK(tree[1].lines.empty());
  CHECK_FALSE(tree[2].executable);
  CHECK(tree[2].lines.size() == 2);
}

}  // namespace
