// That what the program computes has not changed, to the bit: the states of the gallery's scenes as they were
// when the list was written. A change that means to change the motion writes the list anew, and says so.

#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>

#include <catch2/catch.hpp>

#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "sim/dynamics/simulation.h"
#include "tests/support/kernels.h"

namespace {

const std::filesystem::path kRoot = SMITHEREENS_SOURCE_DIR;

struct Row {
  std::string scene;
  double seconds = 0.0;
  std::string hash;
};

/// The scenes that take long by their full time are left out, or the only ones.
std::vector<Row> listed(bool large) {
  constexpr double kWhole = 0.05;
  std::ifstream file(kRoot / "tests/data/state-hashes.txt");
  std::vector<Row> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    Row row;
    std::istringstream(line) >> row.scene >> row.seconds >> row.hash;
    const bool heavy =
        row.scene == "teapot-drop-fine" || row.scene == "tipsy-table" || row.scene == "vase-in-dish";
    if ((heavy && row.seconds == kWhole) == large) rows.push_back(row);
  }
  return rows;
}

std::string hashAt(const Row& row, int threads) {
  const std::filesystem::path folder = kRoot / "resources/scenes";
  const auto loaded = modeling::loadScene(folder / (row.scene + ".scene.json"));
  REQUIRE(loaded.ok());
  auto built = modeling::build(loaded->scene, folder);
  REQUIRE(built.ok());
  built->conditions.settings.threads = threads;
  auto simulation = sim::Simulation::create(std::move(built->network), built->conditions.environment,
                                            built->conditions.tracks, built->conditions.settings);
  REQUIRE(simulation.ok());
  REQUIRE((*simulation)->advanceTo(row.seconds).ok());
  std::ostringstream text;
  text << std::hex << std::setw(16) << std::setfill('0') << (*simulation)->stateHash();
  return text.str();
}

void checkRows(bool large) {
  // The kernels for other instruction sets round in other places.
  const tests::ChosenKernel plain("plain");
  const std::vector<Row> rows = listed(large);
  CHECK(rows.size() >= 3);
  for (const Row& row : rows) {
    for (const int threads : {1, 2}) {
      INFO(row.scene << " after " << row.seconds << " s by " << threads << " threads");
      CHECK(hashAt(row, threads) == row.hash);
    }
  }
}

TEST_CASE("the gallery's scenes move as they did, to the bit") {
  checkRows(false);
}

TEST_CASE("the gallery's long scenes move as they did, to the bit", "[large]") {
  checkRows(true);
}

}  // namespace
