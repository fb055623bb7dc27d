#include <algorithm>
#include <filesystem>
#include <fstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace {

using Json = nlohmann::json;

/// A soft plate that falls on an edge and breaks within 0.03 s.
constexpr const char* kPlate = R"({"smithereens": 1, "name": "a plate falls",
 "materials": {"biscuit": {"youngsModulus": 2e8, "density": 2, "threshold": {"mean": 0.004, "spread": 0.2}}},
 "parts": [{"name": "plate", "kind": "slab", "material": "biscuit", "size": [6, 6, 1], "resolution": {"cellSize": 1},
   "worldFromPart": {"position": [0, 0, 2.5], "rotation": [25, 10, 0]}, "velocity": [0, 0, -300]}],
 "environment": {"colliders": [{"name": "floor", "kind": "floor"}]},
 "output": {"duration": 0.03, "fps": 500}})";

class PlateFolder {
 public:
  PlateFolder() : folder_(tests::freshFolder("smithereens-cli")) { std::ofstream(scene()) << kPlate; }
  ~PlateFolder() { std::filesystem::remove_all(folder_); }

  std::string scene() const { return file("plate.scene.json"); }
  std::string file(const std::string& name) const { return folder_ + "/" + name; }
  Json json(const std::string& name) const { return Json::parse(std::ifstream(file(name))); }

 private:
  std::string folder_;
};

tests::Answer simulate(const PlateFolder& folder, const std::string& name, const std::string& options) {
  return tests::runCli("simulate " + folder.scene() + " --take " + folder.file(name + ".take") +
                       " --report " + folder.file(name + ".json") + " " + options);
}

TEST_CASE("each command explains itself in words that can be read") {
  const auto isReadable = [](unsigned char letter) {
    return letter == '\n' || (letter >= ' ' && letter < 0x7f);
  };
  const auto main = tests::runCli("--help");
  REQUIRE(main.status == 0);
  for (const std::string command :
       {"simulate", "resume", "info", "render", "export", "import-lammps", "sweep", "calibrate", "bench",
        "bench throughput", "bench accuracy", "bench contact", "bench all"}) {
    INFO(command);
    CHECK(main.output.find("  " + command.substr(0, command.find(' '))) != std::string::npos);
    const auto answer = tests::runCli(command + " --help");
    CHECK(answer.status == 0);
    CHECK(answer.errors.empty());
    CHECK(answer.output.find("smithereens-cli " + command) != std::string::npos);
    CHECK(std::all_of(answer.output.begin(), answer.output.end(), isReadable));
  }
  // How the value that holds unless one is given is set apart differs by the version of CLI11.
  const std::string exportHelp = tests::runCli("export --help").output;
  const std::string choices = "{shards,tetrahedra,spheres,given-to-neighbours}";
  CHECK((exportHelp.find(choices + "=shards") != std::string::npos ||
         exportHelp.find(choices + " [shards]") != std::string::npos));
}

TEST_CASE("a run leaves a report with everything it promises") {
  const PlateFolder folder;
  const auto answer = simulate(folder, "run", "");
  INFO(answer.errors);
  REQUIRE(answer.status == 0);
  CHECK(answer.errors.empty());  // progress is for terminals
  const Json report = folder.json("run.json");
  for (const char* key :
       {"nodes",        "bonds",      "cells",  "components",  "fragments", "isolated_nodes", "broken_bonds",
        "broken_cells", "steps",      "step_s", "simulated_s", "wall_s",    "cpu_s",          "threads",
        "method",       "state_hash", "energy", "momentum",    "work",      "events"}) {
    INFO(key);
    CHECK(report.contains(key));
  }
  for (const char* key : {"kinetic", "elastic", "gravity", "contact", "dissipated", "released", "total",
                          "max_rise", "residual"}) {
    INFO(key);
    CHECK(report["energy"].at(key).is_number());
  }
  CHECK(report["momentum"]["linear"].size() == 3);
  CHECK(report["momentum"]["angular"].size() == 3);
  for (const char* key : {"bonds_evaluated", "bonds_skipped", "contact_pairs", "labelings", "steps_rigid"}) {
    INFO(key);
    CHECK(report["work"].contains(key));
  }
  CHECK(report["broken_bonds"].get<int>() > 0);
  CHECK(report["events"]["breaks"] == report["broken_bonds"]);
  CHECK(report["events"]["first_break_s"].get<double>() > 0.0);
  CHECK(report["nodes"] == 7 * 7 * 2);
  CHECK(report["components"] == 1);
}

TEST_CASE("the same scene comes to the same end on any number of threads, and another seed to another") {
  const PlateFolder folder;
  const auto hashOf = [&](const std::string& options) {
    REQUIRE(simulate(folder, "run", options).status == 0);
    return folder.json("run.json")["state_hash"].get<std::string>();
  };
  const std::string hash = hashOf("--threads 1");
  CHECK(hashOf("--threads 2") == hash);
  CHECK(hashOf("--threads 3 --fps 50") == hash);  // when frames are taken does not matter either
  CHECK(hashOf("--seed 2") != hash);
}

TEST_CASE("a killed run goes on to the same end") {
  const PlateFolder folder;
  REQUIRE(simulate(folder, "whole", "").status == 0);
  const std::string take = folder.file("cut.take");
  for (const int percent : {20, 50, 80}) {
    // What a kill leaves is a beginning of the file (each append is whole or absent).
    std::filesystem::copy_file(folder.file("whole.take"), take,
                               std::filesystem::copy_options::overwrite_existing);
    std::filesystem::resize_file(take,
                                 std::filesystem::file_size(take) * static_cast<unsigned>(percent) / 100);
    const auto answer = tests::runCli("resume " + take + " --report " + folder.file("cut.json"));
    INFO(answer.errors);
    REQUIRE(answer.status == 0);
    const Json whole = folder.json("whole.json");
    const Json resumed = folder.json("cut.json");
    for (const char* key : {"state_hash", "steps", "fragments", "broken_bonds", "events", "energy", "work"}) {
      INFO(key);
      CHECK(resumed[key] == whole[key]);
    }
  }
}

TEST_CASE("a finished run goes on past its end as one that was meant to") {
  const PlateFolder folder;
  REQUIRE(simulate(folder, "short", "").status == 0);
  REQUIRE(simulate(folder, "long", "--until 0.04").status == 0);
  REQUIRE(tests::runCli("resume " + folder.file("short.take") + " --until 0.04 --report " +
                        folder.file("on.json"))
              .status == 0);
  CHECK(folder.json("on.json")["state_hash"] == folder.json("long.json")["state_hash"]);
  CHECK(Json::parse(tests::runCli("info --json " + folder.file("short.take")).output)["frames"] == 21);
}

TEST_CASE("a run goes on from any frame in a take of its own, as it was or changed") {
  const PlateFolder folder;
  REQUIRE(simulate(folder, "run", "").status == 0);
  const std::string take = folder.file("run.take");
  const auto size = std::filesystem::file_size(take);
  const auto goOn = [&](const std::string& name, const std::string& options) {
    return tests::runCli("resume " + take + " --take " + folder.file(name + ".take") + " --report " +
                         folder.file(name + ".json") + " " + options);
  };
  REQUIRE(goOn("same", "--from 4").status == 0);
  const Json whole = folder.json("run.json");
  for (const char* key : {"state_hash", "steps", "energy", "events"}) {
    INFO(key);
    CHECK(folder.json("same.json")[key] == whole[key]);
  }
  const auto framesOf = [&](const std::string& name) {
    return Json::parse(tests::runCli("info --json " + folder.file(name + ".take")).output)["frames"];
  };
  CHECK(framesOf("same") == framesOf("run"));
  REQUIRE(goOn("other", "--time 0.008 --set environment.gravity=[0,0,2000]").status == 0);
  CHECK(folder.json("other.json")["state_hash"] != whole["state_hash"]);
  CHECK(framesOf("other") == framesOf("run"));
  // What is put into a part is told of, with its depth.
  const auto raised = goOn("raised", R"(--from 0 --set 'environment.colliders.floor.position=[0,0,1.5]')");
  CHECK(raised.status == 0);
  CHECK(raised.errors.starts_with("warning: the part \"plate\" begins"));
  // A killed one goes on in place.
  std::filesystem::resize_file(folder.file("other.take"),
                               std::filesystem::file_size(folder.file("other.take")) * 9 / 10);
  REQUIRE(tests::runCli("resume " + folder.file("other.take") + " --report " + folder.file("again.json"))
              .status == 0);
  CHECK(folder.json("again.json")["state_hash"] == folder.json("other.json")["state_hash"]);
  CHECK(std::filesystem::file_size(take) == size);

  const std::pair<std::string, std::string> wrong[] = {
      {"--from 4", "--take: a run that goes on from a frame needs a take of its own"},
      {"--from 4 --take " + take, "--take: this is the take that is gone on from"},
      {"--from 4 --take x.take --until nan", "command line: --until: not a finite number"},
      {"--from 4000 --take x.take", "--from: the take does not have a frame 4000"},
      {"--take x.take", "command line: --take and --set need a frame"},
      {"--from 4 --take x.take --set parts.plate.velocity=[0,0,0]", "--set parts: the parts are not those"},
      {"--from 4 --take x.take --set environment.gravty=3", "--set environment.gravty:1:1: there is no key"},
  };
  for (const auto& [arguments, line] : wrong) {
    const auto answer = tests::runCli("resume " + take + " " + arguments);
    INFO(arguments + " -> " + answer.errors);
    CHECK(answer.status == 2);
    CHECK(answer.errors.starts_with(line));
    CHECK(std::count(answer.errors.begin(), answer.errors.end(), '\n') == 1);
  }
  CHECK_FALSE(std::filesystem::exists("x.take"));
}

TEST_CASE("options change what they say, and settings anything") {
  const PlateFolder folder;
  REQUIRE(simulate(folder, "run",
                   "--until 0.001 --method symplectic-euler --step 1e-5 --set environment.gravity=[0,0,0] "
                   "--set parts.plate.velocity=[0,0,0]")
              .status == 0);
  const Json report = folder.json("run.json");
  CHECK(report["method"] == "symplectic-euler");
  CHECK(report["step_s"] == 1e-5);
  CHECK(report["steps"] == 100);
  CHECK(report["energy"]["kinetic"].get<double>() < 1e-12);  // nothing acts: only rounding moves it
}

TEST_CASE("a key that means nothing any more is told once on standard error, and the run is the same") {
  const PlateFolder folder;
  REQUIRE(simulate(folder, "new", "--until 0.002").status == 0);
  const auto answer = simulate(folder, "old", "--until 0.002 --set solver.precision=float");
  CHECK(answer.status == 0);
  CHECK(answer.errors.starts_with("note: --set solver.precision:"));
  CHECK(std::count(answer.errors.begin(), answer.errors.end(), '\n') == 1);
  CHECK(folder.json("old.json")["state_hash"] == folder.json("new.json")["state_hash"]);
}

TEST_CASE("a tolerance makes the steps of a run shorter") {
  const PlateFolder folder;
  REQUIRE(simulate(folder, "loose", "--until 0.001").status == 0);
  REQUIRE(simulate(folder, "tight", "--until 0.001 --tolerance 1e-5").status == 0);
  CHECK(folder.json("tight.json")["steps"] > folder.json("loose.json")["steps"]);
}

TEST_CASE("a wrong input ends with status 2 and one line that says where and how to mend it") {
  const PlateFolder folder;
  const std::string scene = folder.scene();
  const std::pair<std::string, std::string> wrong[] = {
      {"simulate " + scene + " --method rk5", "--method:1:1: method does not know \"rk5\"; did you mean"},
      {"simulate " + scene + " --step nan", "--step:1:1: step does not know \"nan\"; did you mean \"auto\""},
      {"simulate " + scene + " --tolerance 2",
       "--tolerance:1:14: tolerance holds 2; give a number from 1e-12 to 1"},
      {"simulate " + scene + " --until -1", "--until:1:1: duration holds -1; give a number from 0 to 1e+06"},
      {"simulate " + scene + " --set output.fsp=3",
       "--set output.fsp:1:1: there is no key \"fsp\" here; did you mean \"fps\""},
      {"simulate " + scene + " --threads -3", "command line: "},
      {"simulate " + scene + " --take /nowhere/x.take", "/nowhere/x.take"},
      {"simulate " + scene + " --report /nowhere/r.json", "/nowhere/r.json: this file cannot be written"},
      {"simulate " + folder.file("none.json"),
       folder.file("none.json") + ":1:1: there is no such file; check the path"},
      {"simulate", "command line: scene is required; see smithereens-cli --help"},
      {"resume " + scene, scene},
      {"info " + folder.file(""), folder.file("") + ":1:1: this is not a file"},
      {"dance", "command line: "},
      {"", "command line: "},
  };
  for (const auto& [arguments, line] : wrong) {
    const auto answer = tests::runCli(arguments);
    INFO(arguments + " -> " + answer.errors);
    CHECK(answer.status == 2);
    CHECK(answer.output.empty());
    CHECK(answer.errors.starts_with(line));
    CHECK(std::count(answer.errors.begin(), answer.errors.end(), '\n') == 1);
  }
}

TEST_CASE("an export refuses choices that its format cannot show") {
  const PlateFolder folder;
  REQUIRE(simulate(folder, "run", "").status == 0);
  const auto exported = [&](const std::string& format, const std::string& options) {
    return tests::runCli("export " + folder.file("run.take") + " --frames 0 --format " + format + " --out " +
                         folder.file("out." + format) + " " + options);
  };
  for (const char* format : {"xyz", "vtk", "csv", "lammps"}) {
    const auto answer = exported(format, "--loose-nodes spheres");
    CHECK(answer.status == 2);
    CHECK_THAT(answer.errors, Catch::Contains("--loose-nodes") && Catch::Contains("no surface"));
  }
  CHECK(exported("pc2", "--level-surface").status == 2);
  CHECK(exported("xyz", "").status == 0);
  for (const char* format : {"glb", "obj", "ply", "pc2"})
    CHECK(exported(format, "--loose-nodes spheres").status == 0);
}

TEST_CASE("a problem found while building is told by line and column, too") {
  const PlateFolder folder;
  std::string text = kPlate;
  const std::string place = "\"cellSize\": 1";
  text.replace(text.find(place), place.size(), "\"cellSize\": 1e-4");
  std::ofstream(folder.scene()) << text;
  const auto answer = tests::runCli("simulate " + folder.scene());
  INFO(answer.errors);
  CHECK(answer.status == 2);
  CHECK(answer.errors.starts_with(folder.scene() + ":3:"));
}

TEST_CASE("a run that cannot begin leaves an older take alone") {
  const PlateFolder folder;
  REQUIRE(simulate(folder, "run", "").status == 0);
  const auto size = std::filesystem::file_size(folder.file("run.take"));
  CHECK(simulate(folder, "run", "--method forward-euler --set materials.biscuit.lossFactor=0").status == 2);
  CHECK(std::filesystem::file_size(folder.file("run.take")) == size);
}

TEST_CASE("a step that cannot be stable is refused before anything is recorded") {
  const PlateFolder folder;
  const auto answer = simulate(folder, "run", "--step 2e-3");
  INFO(answer.errors);
  CHECK(answer.status == 2);
  CHECK(answer.errors.find("solver.step:1:1: the step is longer than ") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(folder.file("run.take")));
}

TEST_CASE("a blow-up ends with status 1, names its cause, and keeps what was recorded") {
  const PlateFolder folder;
  // Nothing a scene may ask for by itself is faster than light; this falls until it is.
  const auto answer = simulate(folder, "run",
                               "--set environment.gravity=[0,0,-1e8] --set environment.colliders=[] "
                               "--set 'tracks=[{\"target\":\"gravity.scale\",\"keys\":[[0,1e6]]}]'");
  INFO(answer.errors);
  CHECK(answer.status == 1);
  CHECK(answer.errors.find("biscuit") != std::string::npos);
  CHECK(folder.json("run.json")["outcome"] != "done");
  const Json take = Json::parse(tests::runCli("info --json " + folder.file("run.take")).output);
  CHECK(take["frames"].get<int>() >= 1);
  CHECK(take["outcome"] == folder.json("run.json")["outcome"]);
}

TEST_CASE("info says what a scene will be before it runs") {
  const PlateFolder folder;
  const auto answer = tests::runCli("info --json " + folder.scene());
  REQUIRE(answer.status == 0);
  const Json info = Json::parse(answer.output);
  CHECK(info["kind"] == "scene");
  CHECK(info["nodes"] == 98);
  CHECK(info["mass_g"].get<double>() == Approx(2.0 * 36.0));
  CHECK(info["parts"][0]["worst_scaled_jacobian"].get<double>() == Approx(1.0));
  const Json& flight = info["preflight"];
  CHECK(flight["bonds_broken_at_rest"] == 0);
  CHECK(flight["stable_step_limited_by"] == "contact");  // an edge is about to meet the floor
  CHECK(flight["worst_cells"].size() == 5);
  CHECK(flight["stable_step_s"].get<double>() > 0.0);
  // Where all fly rigidly, steps are up to twice as long.
  const double most = 0.03 / flight["step_s"].get<double>();
  CHECK(flight["steps"].get<double>() < most + 1.0);
  CHECK(flight["steps"].get<double>() > 0.5 * most);
  CHECK(flight["frames"] == 16);
  CHECK(tests::runCli("info " + folder.scene()).output.find("stable step s") != std::string::npos);
}

TEST_CASE("info counts the bonds that would break before anything moves") {
  const std::string scene = "\"" SMITHEREENS_SOURCE_DIR "/tests/data/lammps-bar/bar.scene.json\"";
  const PlateFolder folder;
  std::ofstream(folder.file("pair.data"))
      << "two nodes\n\n2 atoms\n1 bonds\n\nMasses\n\n1 1\n\nAtoms\n\n1 1 1 0 0 0\n"
         "2 1 1 1.5 0 0\n\nBonds\n\n1 1 1 2\n";
  std::ofstream(folder.file("pair.scene.json"))
      << R"({"smithereens": 1, "parts": [{"name": "pair", "kind": "network", "file": "pair.data", "format": "lammps",
             "bondTypes": {"1": {"stiffness": 10, "restLength": 1, "threshold": 0.4}}}]})";
  const Json info = Json::parse(tests::runCli("info --json " + folder.file("pair.scene.json")).output);
  CHECK(info["preflight"]["bonds_broken_at_rest"] == 1);
  CHECK(Json::parse(tests::runCli("info --json " + scene).output)["preflight"]["bonds_broken_at_rest"] == 0);
}

TEST_CASE("info says what memory a run takes") {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  const PlateFolder folder;
  for (const char* const cell : {"1", "0.25", "0.12"}) {
    std::string scene = kPlate;
    scene.replace(scene.find("\"cellSize\": 1"), 13, std::string("\"cellSize\": ") + cell);
    std::ofstream(folder.scene()) << scene;
    const Json info = Json::parse(tests::runCli("info --json " + folder.scene()).output);
    const auto peak = static_cast<double>(tests::peakMemoryOf(
        {SMITHEREENS_CLI, "simulate", folder.scene(), "--until", "0.001", "--take", folder.file("it.take")}));
    INFO(cell);
    // Of the two, one holds the network twice, the other a take that is written.
    CHECK(info["preflight"]["memory_bytes"].get<double>() == Approx(peak).epsilon(0.25));
  }
#endif
}

TEST_CASE("info says how many steps a run takes, as tracks stiffen and speed shortens them") {
  const PlateFolder folder;
  // Jelly, so that not the lattice but the way that a node may go in a step counts as it falls.
  const std::string jelly =
      R"({"smithereens": 1, "materials": {"jelly": {"youngsModulus": 2e4, "density": 1, "lossFactor": 0.3}},
 "parts": [{"name": "plate", "kind": "slab", "material": "jelly", "size": [4, 4, 2], "resolution": {"cellSize": 1},
   "worldFromPart": {"position": [0, 0, HEIGHT]}}],
 "environment": {"colliders": [{"name": "floor", "kind": "floor"}]}, TRACKS
 "output": {"duration": 0.4, "fps": 24}})";
  const auto ratioOf = [&](const std::string& height, const std::string& tracks) {
    std::string scene = jelly;
    scene.replace(scene.find("HEIGHT"), 6, height);
    scene.replace(scene.find("TRACKS"), 6, tracks);
    std::ofstream(folder.scene()) << scene;
    const Json info = Json::parse(tests::runCli("info --json " + folder.scene()).output);
    REQUIRE(tests::runCli("simulate " + folder.scene() + " --report " + folder.file("r.json")).status == 0);
    return info["preflight"]["steps"].get<double>() / folder.json("r.json")["steps"].get<double>();
  };
  CHECK(ratioOf("500", "") == Approx(1.0).epsilon(0.1));
  CHECK(ratioOf("500",
                R"("tracks": [{"target": "stiffness.scale", "keys": [[0, 1], [0.2, 1], [0.201, 400]]}],)") ==
        Approx(1.0).epsilon(0.1));
}

TEST_CASE("names and paths that are printed cannot steer a terminal") {
  const PlateFolder folder;
  std::string scene = kPlate;
  scene.replace(scene.find("a plate falls"), 13, R"(\u001b[2J\u202e\u0007cup)");
  scene.replace(scene.find("\"name\": \"plate\""), 15, R"("name": "\u001b[31mplate\nwarnings: none")");
  std::ofstream(folder.scene()) << scene;
  const auto info = tests::runCli("info " + folder.scene());
  REQUIRE(info.status == 0);
  const auto missing = tests::runCli("info '" + folder.file("\x1b[2J.scene.json") + "'");
  const auto wrong = tests::runCli("simulate " + folder.scene() + " --set \"$(printf 'parts.\\033[2J=1')\"");
  CHECK(missing.status == 2);
  CHECK(wrong.status == 2);
  for (const std::string& text : {info.output, info.errors, missing.errors, wrong.errors}) {
    INFO(text);
    CHECK(std::none_of(text.begin(), text.end(),
                       [](char letter) { return letter == '\x1b' || letter == '\x07'; }));
    CHECK(text.find("\xe2\x80\xae") == std::string::npos);
  }
  CHECK_THAT(info.output, Catch::Contains("\\x1b[31mplate\\nwarnings: none"));
  CHECK_THAT(missing.errors, Catch::Contains("\\x1b[2J"));
}

}  // namespace
