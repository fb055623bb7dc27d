#include <cstdlib>
#include <fstream>
#include <random>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "modeling/scene/scene_file.h"
#include "modeling/text/json_text.h"
#include "tests/modeling/scene_examples.h"

namespace {

using modeling::parseScene;
using modeling::Scene;
using modeling::SceneFile;
using modeling::writeScene;
using tests::kFullScene;
using tests::kPlainScene;

Scene sceneOf(const std::string& text) {
  sim::Result<SceneFile> file = parseScene(text, "test.scene.json");
  if (!file) FAIL(file.problem().line());
  return file->scene;
}

TEST_CASE("a scene that is written and read is the same scene") {
  for (const std::string& text : {kPlainScene, kFullScene}) {
    const Scene scene = sceneOf(text);
    const std::string written = writeScene(scene);
    CHECK(sceneOf(written) == scene);
    CHECK(writeScene(sceneOf(written)) == written);
  }
}

TEST_CASE("each form of a step survives writing and reading") {
  Scene scene = sceneOf(kPlainScene);
  for (const modeling::Step& step :
       {modeling::Step{}, modeling::Step{2e-6, std::nullopt}, modeling::Step{std::nullopt, 1e-3}}) {
    scene.solver.step = step;
    CHECK(sceneOf(writeScene(scene)).solver.step == step);
  }
}

TEST_CASE("no value of the full scene is left behind") {
  const Scene scene = sceneOf(kFullScene);
  CHECK(scene.name == "everything");
  CHECK(scene.materials[0].values.pattern == modeling::BondPattern::fig1);
  CHECK(scene.parts[0].worldFromPart.scale.factors == sim::Vec3(1, 2, 0.5));
  CHECK(std::get<modeling::SlabShape>(scene.parts[0].shape).resolution.counts[0] == 4);
  CHECK_FALSE(std::get<modeling::SlabShape>(scene.parts[0].shape).resolution.counts[1]);
  CHECK(std::get<modeling::RevolutionShape>(scene.parts[2].shape).turnAngle == 1.5 * std::numbers::pi);
  CHECK(std::get<modeling::CurvedCylinderShape>(scene.parts[3].shape).section == modeling::SweepSection::arc);
  CHECK_FALSE(std::get<modeling::NetworkShape>(scene.parts[4].shape).bondTypes[1].constants.threshold);
  CHECK(scene.glue[1].pairs[1] == std::array<sim::NodeIndex, 2>{1, 4});
  CHECK(std::get<modeling::BoxShape>(scene.environment.colliders[1].form).halfSize.x() == 40);
  CHECK(scene.tracks[4].target.object == "ball");
  CHECK(scene.solver.seed == 18446744073709551615U);
  CHECK(scene.solver.step.seconds == 2e-6);
  CHECK(scene.view.hidden == std::vector<std::string>{"cup"});
  CHECK(scene.view.locked == std::vector<std::string>{"floor", "cup"});
}

std::string textOf(const std::string& file) {
  std::ifstream stream(file);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// Numbers of every magnitude that gravity may have, drawn as bit patterns.
double anyNumber(std::mt19937_64& random) {
  for (;;) {
    const double number = std::bit_cast<double>(random());
    if (std::abs(number) <= 1e8) return number;
  }
}

TEST_CASE("numbers of any magnitude survive writing and reading, bit for bit") {
  std::mt19937_64 random(7);
  Scene scene = sceneOf(kFullScene);
  for (int i = 0; i < 200; ++i) {
    scene.environment.gravity = {anyNumber(random), anyNumber(random), -0.0};
    const Scene again = sceneOf(writeScene(scene));
    for (int axis = 0; axis < 3; ++axis) {
      CHECK(std::bit_cast<std::uint64_t>(again.environment.gravity[axis]) ==
            std::bit_cast<std::uint64_t>(scene.environment.gravity[axis]));
    }
  }
}

TEST_CASE("angles are degrees in the file, and still survive bit for bit whatever their radians") {
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> radians(1e-3, 6.28);
  Scene scene = sceneOf(kFullScene);
  auto& cup = std::get<modeling::RevolutionShape>(scene.parts[2].shape);
  for (int i = 0; i < 300; ++i) {
    cup.turnAngle = radians(random);
    cup.startAngle = -radians(random);
    REQUIRE(sceneOf(writeScene(scene)) == scene);
  }
  CHECK(writeScene(sceneOf(kFullScene)).find("\"turnAngle\": 270") != std::string::npos);
}

TEST_CASE("what has its default value is not written") {
  const std::string written = writeScene(sceneOf(kPlainScene));
  for (const char* key : {"gravity", "solver", "output", "resolution", "look", "density"}) {
    INFO(key);
    CHECK(written.find(key) == std::string::npos);
  }
}

TEST_CASE("a number is written as briefly as it can be read back") {
  CHECK(modeling::shortestNumber(-981.0) == "-981");
  CHECK(modeling::shortestNumber(0.1) == "0.1");
  CHECK(modeling::shortestNumber(6.5e11) == "6.5e+11");
  CHECK(modeling::shortestNumber(-0.0) == "-0.0");
}

TEST_CASE("a preset is laid under the keys that are given", "[presets]") {
  const auto folder = std::filesystem::temp_directory_path() / "smithereens-presets";
  std::filesystem::create_directories(folder / "materials");
  std::ofstream(folder / "materials" / "wax.json")
      << R"({"youngsModulus": 1e7, "density": 0.9, "fractureToughness": 2e6, "plastic": {"yieldStrain": 0.1, "rate": 3}})";
  setenv("SMITHEREENS_RESOURCES", folder.c_str(), 1);
  const std::string text =
      tests::replaced(kPlainScene, R"({"youngsModulus": 1e8})",
                      R"({"preset": "wax", "density": 0.95, "plastic": null, "threshold": {"mean": 0.2}})");
  const Scene scene = sceneOf(text);
  const modeling::Material& clay = scene.materials[0].values;
  CHECK(clay.name == "clay");
  CHECK(clay.youngsModulus == 1e7);
  CHECK(clay.density == 0.95);
  CHECK_FALSE(clay.plastic);
  CHECK(clay.threshold.mean == 0.2);
  CHECK_FALSE(clay.fractureToughness);  // one way to break replaces the other
  CHECK(sceneOf(writeScene(scene)) == scene);
  CHECK(writeScene(scene).find("youngsModulus") == std::string::npos);

  const auto misspelt = parseScene(tests::replaced(text, "\"wax\"", "\"wacks\""), "s");
  unsetenv("SMITHEREENS_RESOURCES");
  REQUIRE_FALSE(misspelt.ok());
  CHECK(misspelt.problem().line() == "s:3:36: there is no material preset \"wacks\"; did you mean \"wax\"");
  const Scene alone = sceneOf(writeScene(modeling::withoutPresets(scene)));
  CHECK(alone.materials[0].values == scene.materials[0].values);
}

TEST_CASE("the schema in resources is the one made from the reader's keys") {
  // SMITHEREENS_RENEW_SCHEMA=1 in the environment writes it anew.
  const std::string file = SMITHEREENS_SOURCE_DIR "/resources/scenes/scene.schema.json";
  if (std::getenv("SMITHEREENS_RENEW_SCHEMA") != nullptr) std::ofstream(file) << modeling::sceneSchema();
  CHECK(textOf(file) == modeling::sceneSchema());
}

void collectKeys(const nlohmann::json& schema, std::set<std::string>& keys) {
  if (schema.is_object() && schema.contains("properties")) {
    for (const auto& [key, property] : schema["properties"].items()) keys.insert(key);
  }
  if (!schema.is_structured()) return;
  for (const auto& part : schema) collectKeys(part, keys);
}

TEST_CASE("the description of the format leaves no key out") {
  std::set<std::string> keys;
  collectKeys(nlohmann::json::parse(modeling::sceneSchema()), keys);
  CHECK(keys.size() > 80);
  const std::string text = textOf(SMITHEREENS_SOURCE_DIR "/docs/formats.md");
  for (const std::string& key : keys) {
    INFO(key);
    const bool alone = text.find("`" + key + "`") != std::string::npos;
    const bool inGroup = text.find("." + key + "`") != std::string::npos;
    CHECK((alone || inGroup || key == "radians"));
  }
}

TEST_CASE("the example in the description of the format is a scene") {
  const std::string text = textOf(SMITHEREENS_SOURCE_DIR "/docs/formats.md");
  const std::size_t start = text.find("```json\n") + 8;
  const Scene scene = sceneOf(text.substr(start, text.find("```", start) - start));
  CHECK(scene.parts.size() == 1);
}

TEST_CASE("saving replaces the file as a whole") {
  const auto file = std::filesystem::temp_directory_path() / "smithereens-save.scene.json";
  const Scene scene = sceneOf(kFullScene);
  REQUIRE(modeling::saveScene(sceneOf(kPlainScene), file).ok());
  REQUIRE(modeling::saveScene(scene, file).ok());
  const auto loaded = modeling::loadScene(file);
  REQUIRE(loaded.ok());
  CHECK(loaded->scene == scene);
  std::filesystem::remove(file);
  CHECK_FALSE(modeling::saveScene(scene, "/nowhere/at/all.scene.json").ok());
}

}  // namespace
