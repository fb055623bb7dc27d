#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>

#include <catch2/catch.hpp>

#include "tests/support/run_program.h"

/// No command spoils a file that it was not asked to replace.
namespace {

namespace fs = std::filesystem;

constexpr const char* kPlate = R"({"smithereens": 1, "name": "a plate falls",
 "materials": {"biscuit": {"youngsModulus": 2e8, "density": 2, "threshold": {"mean": 0.004, "spread": 0.2}}},
 "parts": [{"name": "plate", "kind": "slab", "material": "biscuit", "size": [3, 3, 1], "resolution": {"cellSize": 1},
   "worldFromPart": {"position": [0, 0, 2.5]}, "velocity": [0, 0, -300]}],
 "environment": {"colliders": [{"name": "floor", "kind": "floor"}]},
 "output": {"duration": 0.004, "fps": 500}})";

/// A folder with a scene, its take and files of a person's own.
class Desk {
 public:
  Desk() : folder_(tests::freshFolder("smithereens-outputs")) {
    write("s.scene.json", kPlate);
    REQUIRE(run("simulate S --take T").status == 0);
    write("thesis.txt", "In the beginning there was a cup.\n");
    fs::create_symlink("s.scene.json", folder_ / "link.json");
    fs::create_hard_link(folder_ / "t.take", folder_ / "twin.take");
    fs::create_directory(folder_ / "folder");
  }
  ~Desk() { fs::remove_all(folder_); }
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  std::string file(const std::string& name) const { return (folder_ / name).string(); }
  /// In the folder; S and T stand for the scene and its take.
  tests::Answer run(const std::string& arguments) const {
    std::string all;
    std::istringstream words(arguments);
    for (std::string word; words >> word;) {
      if (word == "S") word = "s.scene.json";
      if (word == "T") word = "t.take";
      all.append(" ").append(word);
    }
    return tests::runCommand("cd " + folder_.string() + " && \"" SMITHEREENS_CLI "\"" + all);
  }
  /// All files with what is in them.
  std::map<std::string, std::string> content() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream stream(entry.path(), std::ios::binary);
      all[entry.path().string()] = {std::istreambuf_iterator<char>(stream), {}};
    }
    return all;
  }

 private:
  fs::path folder_;
};

constexpr const char* kSmall = " --size 8x8 --samples 1";

TEST_CASE("an output never replaces what is read, a folder, another output or a file of another kind") {
  const Desk desk;
  const auto before = desk.content();
  for (const std::string arguments : {"simulate S --take S",
                                      "simulate S --report S",
                                      "simulate S --take link.json",
                                      "simulate S --report T",
                                      "simulate S --take thesis.txt",
                                      "simulate S --report thesis.txt",
                                      "simulate S --take folder",
                                      "simulate S --take x --report x",
                                      "simulate S --take x --report ./x",
                                      "resume T --report T",
                                      "resume T --report twin.take",
                                      "resume T --from 0 --take twin.take",
                                      "resume T --from 0 --take S",
                                      "export T --format xyz --out T",
                                      "export T --format xyz --out thesis.txt",
                                      "export T --format csv --out S",
                                      "export T --format obj --out twin.take --frames 0",
                                      "render T --out T",
                                      "render T --out thesis.txt",
                                      "render T --out twin.take",
                                      "render T --out folder",
                                      "sweep S --vary solver.seed=1,2 --out thesis.txt",
                                      "import-lammps thesis.txt --scene S --take thesis.txt",
                                      "import-lammps thesis.txt --scene S --take S"}) {
    INFO(arguments);
    const auto answer = desk.run(arguments + (arguments.starts_with("render") ? kSmall : ""));
    INFO(answer.errors);
    CHECK(answer.status == 2);
    CHECK_FALSE(answer.errors.empty());
    CHECK(desk.content() == before);
  }
}

TEST_CASE("what is read stays even where a person forces") {
  const Desk desk;
  const auto before = desk.content();
  for (const std::string arguments :
       {"simulate S --take S", "simulate S --report link.json", "resume T --from 0 --take twin.take",
        "resume T --report T", "export T --format xyz --out T", "render T --out twin.take",
        "import-lammps thesis.txt --scene S --take thesis.txt"}) {
    INFO(arguments);
    const auto answer = desk.run(arguments + " --force" + (arguments.starts_with("render") ? kSmall : ""));
    CHECK(answer.status == 2);
    CHECK(desk.content() == before);
  }
}

TEST_CASE("files of the kind are replaced, and others where a person forces") {
  const Desk desk;
  for (const std::string arguments :
       {"simulate S --take t2.take --report r.json", "resume T --from 0 --take t3.take --report r.json",
        "export T --format glb --out o.glb", "export T --format csv --out o.csv", "render T --out o.png"}) {
    INFO(arguments);
    const std::string small = arguments.starts_with("render") ? kSmall : "";
    CHECK(desk.run(arguments + small).status == 0);
    CHECK(desk.run(arguments + small).status == 0);
  }
  desk.write("o.png", "not a picture");
  CHECK(desk.run(std::string("render T --out o.png") + kSmall).status == 2);
  CHECK(desk.run(std::string("render T --out o.png --force") + kSmall).status == 0);
  CHECK(desk.run("simulate S --take thesis.txt --force").status == 0);
  CHECK(desk.run("info thesis.txt").status == 0);
}

TEST_CASE("files that a scene is made of are read, and one of many numbered pictures may be one of them") {
  const Desk desk;
  REQUIRE(desk.run(std::string("render T --out sky.0001.png --time 0") + kSmall).status == 0);
  const auto before = desk.content();
  const auto answer =
      desk.run(std::string("render T --out sky.png --frames 0:1 --environment sky.0001.png") + kSmall);
  CHECK(answer.status == 2);
  CHECK(answer.errors.find("sky.0001.png") != std::string::npos);
  CHECK(desk.content() == before);
}

TEST_CASE("a report may go where standard output goes, and to nowhere") {
  const Desk desk;
  const auto piped = desk.run("simulate S --report /dev/stdout");
  CHECK(piped.status == 0);
  CHECK(piped.output.find("\"state_hash\"") != std::string::npos);
  CHECK(desk.run("simulate S --report /dev/stdout > both.txt").status == 0);
  const std::string both = desk.content().at(desk.file("both.txt"));
  CHECK(both.find("\"state_hash\"") != std::string::npos);
  CHECK(both.find("wall clock") != std::string::npos);
  CHECK(desk.run("simulate S --take /dev/null --report /dev/null").status == 0);
  CHECK(desk.run("simulate S --take /dev/stdout").status == 2);
  // What is named after it would stand beside it.
  CHECK(desk.run("export T --format csv --out /dev/stdout").status == 2);
  CHECK(desk.run(std::string("render T --out /dev/null") + kSmall).status == 2);
  CHECK(desk.run("export T --format xyz --out /dev/stdout").output.find("Properties=") != std::string::npos);
  CHECK(desk.run("simulate S --take new.take > new.take").status == 2);
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("a sweep takes its own files from before for its own, and no others") {
  const Desk desk;
  const std::string sweep = "sweep S --vary solver.seed=1,2 --out out";
  REQUIRE(desk.run(sweep).status == 0);
  CHECK(desk.run(sweep).status == 0);
  CHECK(desk.run(sweep + " --collect").status == 0);
  desk.write("out/run-0001.log", "a diary");
  const auto before = desk.content();
  CHECK(desk.run(sweep).status == 2);
  CHECK(desk.content() == before);
  CHECK(desk.run(sweep + " --force").status == 0);
  fs::copy_file(desk.file("s.scene.json"), desk.file("out/run-0000.json"),
                fs::copy_options::overwrite_existing);
  CHECK(desk.run("sweep out/run-0000.json --vary solver.seed=1 --out out --force").status == 2);
}

TEST_CASE("the frames of a film are drawn in a folder of the program's own") {
  if (tests::runCommand("command -v ffmpeg").status != 0) return;
  const Desk desk;
  fs::create_directory(desk.file("film.gif.frames"));
  desk.write("film.gif.frames/frame.0000.png", "mine");
  desk.write("film.gif.part", "mine");
  const auto before = desk.content();
  const std::string film = std::string("render T --out film.gif --frames 0:1") + kSmall;
  CHECK(desk.run(film).status == 2);
  CHECK(desk.content() == before);
  fs::rename(desk.file("film.gif.frames"), desk.file("elsewhere"));
  CHECK(desk.run(film).status == 0);
  CHECK_FALSE(fs::exists(desk.file("film.gif.frames")));
  CHECK(desk.content().at(desk.file("film.gif")).starts_with("GIF8"));
  CHECK(desk.content().at(desk.file("film.gif.part")) == "mine");
  // What a person put beside the frames stays when they go.
  fs::create_directory(desk.file("film.gif.frames"));
  desk.write("film.gif.frames/.smithereens-frames", "");
  desk.write("film.gif.frames/notes.txt", "mine");
  CHECK(desk.run(film).status == 0);
  CHECK(fs::exists(desk.file("film.gif.frames/notes.txt")));
  CHECK_FALSE(fs::exists(desk.file("film.gif.frames/frame.0000.png")));
}

TEST_CASE("results of a benchmark do not replace files of another kind") {
  const Desk desk;
  desk.write("folder/scaling.json", R"({"smithereens": 1})");
  desk.write("folder/benchmarks.md", "A page without marks.");
  const auto before = desk.content();
  CHECK(desk.run("bench scaling --out folder").status == 2);
  CHECK(desk.run("bench all --reuse --docs folder").status == 2);
  CHECK(desk.content() == before);
}

}  // namespace
