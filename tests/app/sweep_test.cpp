#include <filesystem>
#include <fstream>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

/// The command sweep.
namespace {

using Json = nlohmann::json;

/// A soft plate that falls on an edge.
constexpr const char* kPlate = R"({"smithereens": 1, "name": "a plate falls",
 "materials": {"biscuit": {"youngsModulus": 2e8, "density": 2, "threshold": {"mean": 0.004, "spread": 0.2}}},
 "parts": [{"name": "plate", "kind": "slab", "material": "biscuit", "size": [4, 4, 1], "resolution": {"cellSize": 1},
   "worldFromPart": {"position": [0, 0, 1.5], "rotation": [25, 10, 0]}, "velocity": [0, 0, -300]}],
 "environment": {"colliders": [{"name": "floor", "kind": "floor"}]},
 "output": {"duration": 0.01, "fps": 500}})";

struct Folder {
  std::string path = tests::freshFolder("smithereens-sweep");
  Folder() { std::ofstream(path + "/plate.scene.json") << kPlate; }
  ~Folder() { std::filesystem::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  tests::Answer sweep(const std::string& options) const {
    return tests::runCli("sweep " + path + "/plate.scene.json --out " + path + "/out " + options);
  }
  std::string text(const std::string& name) const {
    std::ifstream stream(path + "/out/" + name);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
  }
};

TEST_CASE("a sweep runs every combination, and each run is what the scene alone would be with these values") {
  const Folder folder;
  const auto answer = folder.sweep(
      "--vary 'parts.plate.velocity=[0,0,-100],[0,0,-500]' --vary materials.biscuit.density=2,3 --jobs 2");
  INFO(answer.errors);
  REQUIRE(answer.status == 0);
  const Json rows = Json::parse(folder.text("sweep.json"));
  REQUIRE(rows.size() == 4);
  for (std::size_t run = 0; run < 4; ++run) {
    CHECK(rows[run].at("run") == run);
    CHECK(rows[run].at("outcome") == "done");
    CHECK(rows[run].at("parts.plate.velocity")[2] == (run < 2 ? -100 : -500));
    CHECK(rows[run].at("materials.biscuit.density") == (run % 2 == 0 ? 2 : 3));
  }
  REQUIRE(tests::runCli("simulate " + folder.path + "/plate.scene.json --report " + folder.path +
                        "/one.json --set 'parts.plate.velocity=[0,0,-500]' --set materials.biscuit.density=3")
              .status == 0);
  const Json alone = Json::parse(std::ifstream(folder.path + "/one.json"));
  CHECK(rows[3].at("state_hash") == alone.at("state_hash"));

  const std::string table = folder.text("sweep.csv");
  CHECK(std::count(table.begin(), table.end(), '\n') == 5);
  CHECK(std::filesystem::file_size(folder.path + "/out/sweep.png") > 10000);
}

TEST_CASE("a value that no scene can have is told before anything runs") {
  const Folder folder;
  const auto answer = folder.sweep("--vary materials.biscuit.density=2,-3");
  CHECK(answer.status == 2);
  CHECK_THAT(answer.errors, Catch::Contains("density"));
  CHECK_FALSE(std::filesystem::exists(folder.path + "/out/run-0000.take"));
  CHECK(folder.sweep("--vary materials.biscuit.density").status == 2);
}

TEST_CASE("a job array for Slurm has a task a run, which does what the sweep would have done") {
  const Folder folder;
  REQUIRE(folder.sweep("--vary materials.biscuit.density=2,3,4 --slurm").status == 0);
  const std::string script = folder.text("sweep.slurm");
  CHECK_THAT(script, Catch::Contains("#SBATCH --array=0-2"));
  // Slurm says which task it is.
  for (const char* task : {"0", "2"}) {
    const auto answer = tests::runCommand("SLURM_ARRAY_TASK_ID=" + std::string(task) + " bash " +
                                          folder.path + "/out/sweep.slurm");
    INFO(answer.errors);
    CHECK(answer.status == 0);
  }
  // One task has not run: that is what the table says.
  CHECK(folder.sweep("--vary materials.biscuit.density=2,3,4 --collect").status == 1);
  const Json rows = Json::parse(folder.text("sweep.json"));
  CHECK(rows[0].at("outcome") == "done");
  CHECK_THAT(rows[1].at("outcome").get<std::string>(), Catch::Contains("no report"));
  CHECK(rows[2].at("outcome") == "done");
}

TEST_CASE("a sweep that is asked to end takes its runs along and keeps what had ended") {
  const Folder folder;
  // The first run is over in a moment, the second would take hours. Ends the sweep once that has begun.
  std::ofstream(folder.path + "/stop.bash")
      << "set -m\n\"$1\" sweep \"$2/plate.scene.json\" --out \"$2/out\" --vary output.duration=0.001,100000 "
         "&\n"
         "child=$!\nfor i in $(seq 400); do [ -e \"$2/out/run-0001.take\" ] && break; sleep 0.05; done\n"
         "kill -$3 $child\nwait $child\necho status $?\n"
         "echo left $(ps -eo args | grep -c \"[s]imulate $2\")\n";
  for (const std::string signal : {"TERM", "INT", "HUP", "KILL"}) {
    const auto answer = tests::runCommand("bash " + folder.path + "/stop.bash \"" SMITHEREENS_CLI "\" " +
                                          folder.path + " " + signal + "; sleep 0.5");
    INFO(signal << answer.output << answer.errors);
    CHECK_THAT(answer.output, !Catch::Contains("status 0"));
    if (signal != "KILL") {
      CHECK_THAT(answer.output, Catch::Contains("left 0"));
      CHECK_THAT(answer.errors, Catch::Contains("1 of 2 runs had ended"));
    }
    CHECK(tests::runCommand("ps -eo args | grep -q \"[s]imulate " + folder.path + "\"").status == 1);
    CHECK(Json::parse(folder.text("run-0000.json")).at("outcome") == "done");
    CHECK_FALSE(std::filesystem::exists(folder.path + "/out/run-0001.json"));
    CHECK(folder.sweep("--vary output.duration=0.001,100000 --collect").status == 1);
    CHECK(Json::parse(folder.text("sweep.json")).at(0).at("outcome") == "done");
    std::filesystem::remove_all(folder.path + "/out");
  }
}

}  // namespace
