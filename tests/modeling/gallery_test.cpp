// The scenes of resources/scenes, each defined once and used by gallery, tests and benchmarks.

#include <algorithm>
#include <filesystem>

#include <catch2/catch.hpp>

#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "sim/dynamics/simulation.h"

namespace {

const std::filesystem::path kScenes = std::filesystem::path(SMITHEREENS_SOURCE_DIR) / "resources" / "scenes";

std::vector<std::filesystem::path> gallery() {
  std::vector<std::filesystem::path> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(kScenes)) {
    if (entry.path().string().ends_with(".scene.json")) scenes.push_back(entry.path());
  }
  std::sort(scenes.begin(), scenes.end());
  return scenes;
}

sim::Result<modeling::BuiltScene> built(const std::filesystem::path& file) {
  const auto scene = modeling::loadScene(file);
  if (!scene) return scene.problem();
  return modeling::build(scene->scene, kScenes);
}

sim::Vec3 momentumOf(const sim::Simulation& simulation) {
  return simulation.snapshot().ledger.linearMomentum;
}

TEST_CASE("the gallery has a scene for each figure of the paper and each kind of accident") {
  for (const char* name : {"cylinder", "teapot-squash", "teapot-hiccup", "teapot-sneeze", "teapot-drop",
                           "teapot-drop-fine", "vases-wobble", "rope-coil", "spoon-bend", "plate-shatter",
                           "cup-roll", "pane-and-ball", "tipsy-table", "vase-in-dish"}) {
    INFO(name);
    CHECK(std::filesystem::exists(kScenes / (std::string(name) + ".scene.json")));
  }
}

TEST_CASE("every scene of the gallery is built sound, stands the same in its file, and steps") {
  for (const std::filesystem::path& file : gallery()) {
    INFO(file);
    const auto scene = modeling::loadScene(file);
    REQUIRE(scene.ok());
    const auto again = modeling::parseScene(modeling::writeScene(scene->scene), "written");
    REQUIRE(again.ok());
    CHECK(again->scene == scene->scene);

    auto made = built(file);
    REQUIRE(made.ok());
    CHECK_FALSE(made->network.validate().has_value());
    auto simulation = sim::Simulation::create(std::move(made->network), made->conditions.environment,
                                              made->conditions.tracks, made->conditions.settings);
    REQUIRE(simulation.ok());
    for (int step = 0; step < 64; ++step) REQUIRE((*simulation)->stepOnce().ok());
    CHECK((*simulation)->maxRise() < 0.005);
    CHECK((*simulation)->brokenBondCount() == 0);  // nothing is born broken
  }
}

TEST_CASE("the teapot is one body and a loose lid, and comes in two sizes") {
  for (const auto& [name, least, most] :
       {std::tuple("teapot-drop", 2500, 4500), std::tuple("teapot-drop-fine", 15000, 25000)}) {
    INFO(name);
    auto made = built(kScenes / (std::string(name) + ".scene.json"));
    REQUIRE(made.ok());
    CHECK(made->network.nodeCount() > static_cast<std::size_t>(least));
    CHECK(made->network.nodeCount() < static_cast<std::size_t>(most));
    auto simulation = sim::Simulation::create(std::move(made->network), {}, {}, {});
    REQUIRE(simulation.ok());
    CHECK((*simulation)->snapshot().fragments.size() == 2);
  }
}

TEST_CASE("a falling teapot with nothing outside keeps its momentum while lid and body touch") {
  auto made = built(kScenes / "teapot-hiccup.scene.json");
  REQUIRE(made.ok());
  sim::Environment nothing;
  nothing.gravity.setZero();
  sim::Network network = std::move(made->network);
  // The lid is thrown at the body.
  const auto lid =
      std::find(network.partNames.begin(), network.partNames.end(), "lid") - network.partNames.begin();
  double momentum = 0.0;
  for (std::size_t node = 0; node < network.nodeCount(); ++node) {
    if (network.nodeParts[node] < lid) continue;
    network.velocities[node] = sim::Vec3(5.0, 0.0, -80.0);
    momentum += network.masses[node] * network.velocities[node].norm();
  }
  auto simulation = sim::Simulation::create(std::move(network), nothing, {}, made->conditions.settings);
  REQUIRE(simulation.ok());
  const sim::Vec3 before = momentumOf(**simulation);
  REQUIRE((*simulation)->advanceTo(0.02).ok());
  CHECK((*simulation)->work().contactPairs > 0);
  // Rounding only: forces are equal and opposite to the bit, sums of some thousand terms are not.
  CHECK((momentumOf(**simulation) - before).norm() < 1e-10 * momentum);
}

}  // namespace
