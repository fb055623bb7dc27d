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
  CHECK(habits::strayFolders(treeOf("findings/README.md", "")).empty());
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

TEST_CASE("folders of a room include down the ladder only") {
  checkNone(habits::includesAgainstTheLadder(ourTree()));
  const auto offencesOf = [](const std::string& path, const std::string& line) {
    return habits::includesAgainstTheLadder(treeOf(path, line)).size();
  };
  CHECK(offencesOf("sim/contact/a.h", "#include \"sim/dynamics/b.h\"") == 1);
  CHECK(offencesOf("modeling/shapes/a.cpp", "#include \"modeling/scene/b.h\"") == 1);
  CHECK(offencesOf("ui/session/a.cpp", "#include \"ui/window/b.h\"") == 1);
  CHECK(offencesOf("sim/dynamics/a.cpp", "#include \"sim/contact/b.h\"") == 0);
  CHECK(offencesOf("sim/contact/a.cpp", "#include \"sim/contact/b.h\"") == 0);
  CHECK(offencesOf("ui/picture/compat/embree3/a.h", "#include \"ui/picture/b.h\"") == 0);
  // A ladder is of one room: names of folders may come again in another.
  CHECK(offencesOf("ui/theme/a.cpp", "#include \"modeling/exchange/b.h\"") == 0);
  CHECK(offencesOf("tests/sim/a.cpp", "#include \"tests/ui/b.h\"") == 0);
  CHECK(offencesOf("sim/misc/a.cpp", "") == 1);
  CHECK(offencesOf("sim/a.cpp", "") == 1);
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

TEST_CASE("rules are cited by name") {
  checkNone(habits::codesForRules(ourTree()));
  const auto offencesOf = [](const std::string& path, const std::string& line) {
    return habits::codesForRules(treeOf(path, line)).size();
  };
  // In two halves, so that this file does not cite one itself.
  const std::string code = std::string("P") + "9";
  const std::string other = std::string("B") + "14";
  CHECK(offencesOf("sim/a.h", "/// Contact of two nodes (" + code + ").") == 1);
  CHECK(offencesOf("docs/a.md", "as " + other + " says") == 1);
  CHECK(offencesOf("sim/a.h", "/// docs/numerics.md, Contact 2") == 0);
  CHECK(offencesOf("sim/a.cpp", "int m" + code + ", " + code + "x, " + code + "_, " + code + "12;") == 0);
  CHECK(offencesOf("resources/a.obj", code) == 0);
}

TEST_CASE("a class is defined in one source") {
  checkNone(habits::cutClasses(ourTree()));
  const auto offencesOf = [](const std::string& first, const std::string& second) {
    return habits::cutClasses({File{"sim/a.h", {"class Part {", "  class Piece;"}, false},
                               File{"sim/a.cpp", {first, "}"}, false},
                               File{"sim/b.cpp", {second, "}"}, false},
                               File{"ui/b.cpp", {"void Part::draw() {", "}"}, false}})
        .size();
  };
  CHECK(offencesOf("void Part::move() {", "Part::Part(int size)") == 1);
  CHECK(offencesOf("Part::~Part() {", "const Part::Piece& Part::piece() const {") == 1);
  CHECK(offencesOf("sim::Result<Part> Part::create(int size,", "bool Part::operator()(int size) {") == 1);
  CHECK(offencesOf("void Part::Piece::turn() {", "bool Part::Piece::turned() const {") == 1);
  // The class inside has a source of its own; other lines define nothing of it.
  CHECK(offencesOf("void Part::move() {", "void Part::Piece::turn() {") == 0);
  CHECK(offencesOf("void Part::move() {", "const Part kPart = Part::create(1);") == 0);
  CHECK(offencesOf("void Part::move() {", "  Part::create(1);") == 0);
  CHECK(offencesOf("void Part::move() {", "void move(const Part::Piece& piece) {") == 0);
  // What no header declares may have the same name in several sources.
  CHECK(offencesOf("void Other::move() {", "void Other::turn() {") == 0);
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
  Tree finding = whole;
  finding.push_back(File{"findings/surprise.sh", {"set -e"}, false});
  CHECK(habits::scriptsThatDoNotRun(finding).size() == 1);
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
