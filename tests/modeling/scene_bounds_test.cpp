// Every number of a scene has bounds: within them a scene is built or refused with a reason, beyond them it
// is refused.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <limits>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "modeling/scene/build.h"
#include "modeling/scene/field_info.h"
#include "modeling/scene/scene_file.h"
#include "modeling/scene/scene_ranges.h"
#include "sim/base/random.h"
#include "sim/dynamics/simulation.h"
#include "tests/modeling/scene_examples.h"

namespace {

namespace fs = std::filesystem;
using modeling::FieldInfo;
using modeling::Scene;
using nlohmann::json;

void checkSchema(const json& schema, const std::string& place) {
  if (schema.is_array()) {
    for (std::size_t i = 0; i < schema.size(); ++i) checkSchema(schema[i], place + "/" + std::to_string(i));
    return;
  }
  if (!schema.is_object()) return;
  const auto type = schema.find("type");
  if (type != schema.end() && (*type == "number" || *type == "integer")) {
    INFO(place);
    REQUIRE(schema.contains("minimum"));
    REQUIRE(schema.contains("maximum"));
    CHECK(schema["minimum"].get<double>() < schema["maximum"].get<double>());
    // So that the product of three, a volume or an energy, is still a number.
    CHECK(std::abs(schema["minimum"].get<double>()) <= 1e20);
    CHECK(std::abs(schema["maximum"].get<double>()) <= 1e20);
  }
  for (const auto& [key, value] : schema.items()) checkSchema(value, place + "/" + key);
}

TEST_CASE("the schema states bounds of every number") {
  checkSchema(json::parse(modeling::sceneSchema()), "");
}

/// A folder with the files that the scenes below name.
fs::path folder() {
  const fs::path made = fs::temp_directory_path() / "smithereens-bounds";
  fs::create_directories(made);
  std::ofstream(made / "block.obj")
      << "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n"
         "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
  std::ofstream(made / "bar.data")
      << "bar\n\n2 atoms\n1 bonds\n1 atom types\n1 bond types\n\n0 9 xlo xhi\n0 9 ylo yhi\n"
         "0 9 zlo zhi\n\nMasses\n\n1 1\n\nAtoms # bond\n\n1 1 1 1 1 1\n2 1 1 2 1 1\n\n"
         "Bonds\n\n1 1 1 2\n";
  return made;
}

/// One part and one obstacle, of those kinds.
Scene sceneOf(const std::string& part, const std::string& collider) {
  const std::string text =
      R"({"smithereens": 1, "materials": {"clay": {"youngsModulus": 1e8}}, "parts": [{"name": "it", )" +
      part + R"(}], "environment": {"colliders": [{"name": "thing", )" + collider + "}]}}";
  auto file = modeling::parseScene(text, "s");
  INFO((file ? "" : file.problem().line()));
  REQUIRE(file.ok());
  return file->scene;
}

const char* const kPartKinds[] = {
    R"("kind": "slab", "material": "clay", "size": [4, 2, 2])",
    R"("kind": "patch", "material": "clay", "thickness": 0.5,
       "net": [[[0,0,0],[0,1,0],[0,2,0],[0,3,0]],[[1,0,0],[1,1,0],[1,2,0],[1,3,0]],
               [[2,0,0],[2,1,0],[2,2,0],[2,3,0]],[[3,0,0],[3,1,0],[3,2,0],[3,3,0]]])",
    R"("kind": "revolution", "material": "clay", "outside": [[[3,0],[3,3]]], "inside": [[[2,0],[2,3]]])",
    R"("kind": "curvedCylinder", "material": "clay", "section": "ring", "wallThickness": 0.3, "curve": [[[0,0,0],[0,0,4]]],
       "firstAxis": [1,0,0], "halfWidth": 1, "halfDepth": 1)",
    R"("kind": "network", "file": "bar.data", "format": "lammps", "bondTypes": {"1": {"stiffness": 1000}})",
    R"("kind": "mesh", "material": "clay", "file": "block.obj", "unit": "cm", "up": "z", "cellSize": 1)"};

const char* const kColliderKinds[] = {
    R"("kind": "floor", "position": [0, 0, -9])",
    R"("kind": "box", "position": [0, 0, -9], "halfSize": [1, 1, 1])",
    R"("kind": "sphere", "position": [0, 0, -9], "radius": 1)",
    R"("kind": "cylinder", "position": [0, 0, -9], "radius": 1, "halfHeight": 1)",
    R"("kind": "mesh", "position": [0, 0, -9], "file": "block.obj")"};

/// The places of all numbers of a scene as it is written with every key.
void collect(const json& value, const std::string& place, std::vector<std::string>& places) {
  if (value.is_number() && place != "/smithereens") places.push_back(place);
  if (!value.is_structured()) return;
  for (const auto& [key, item] : value.items()) collect(item, place + "/" + key, places);
}

/// What building and a step of it come to; "" where both are done. Neither may end the program.
std::string buildAndStep(const std::string& text) {
  const auto file = modeling::parseScene(text, "s");
  if (!file) return file.problem().line();
  auto built = modeling::build(file->scene, folder());
  if (!built) {
    CHECK_FALSE(built.problem().what.empty());
    CHECK_FALSE(built.problem().remedy.empty());
    return built.problem().line();
  }
  auto simulation = sim::Simulation::create(std::move(built->network), built->conditions.environment,
                                            built->conditions.tracks, built->conditions.settings);
  if (!simulation) return simulation.problem().line();
  CHECK((*simulation)->step() > 0.0);
  for (int step = 0; step < 2; ++step)
    if (const auto made = (*simulation)->stepOnce(); !made) return made.problem().line();
  return "";
}

const double kTries[] = {0.0, 1e-6, -1.0, 1e3, 1e6, 1e15, 1e30, -1e300};

/// The same, and it may not take long: what is too much is refused by its number. Seconds of the processor,
/// so that other programs do not matter; a fifth of a million nodes are built in less.
std::string triedOut(const std::string& text) {
  const std::clock_t start = std::clock();
  std::string answer = buildAndStep(text);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  INFO(answer);
  CHECK(seconds < 20.0);
  return answer;
}

/// The scene as JSON with all that has a value, whether it is the usual one or not.
json everyKeyOf(const Scene& scene) {
  json root = json::parse(modeling::writeScene(scene));
  json& part = root["parts"][0];
  if (part["kind"] != "network") part["resolution"] = {{"cellSize", 1}};
  if (part["kind"] == "mesh" || part["kind"] == "network") part.erase("resolution");
  part["worldFromPart"] = {{"position", {0, 0, 1}}, {"rotation", {1, 2, 3}}, {"scale", {1, 1, 1}}};
  part["velocity"] = {1, 0, 0};
  part["angularVelocity"] = {0, 1, 0};
  part["hold"] = {{{"min", {-9, -9, -9}}, {"max", {9, 9, 9}}}};
  json& collider = root["environment"]["colliders"][0];
  collider.update({{"rotation", {0, 0, 1}},
                   {"stiffness", 1e6},
                   {"dampingRatio", 0.5},
                   {"friction", 0.5},
                   {"active", {0, 1}}});
  root["environment"]["gravity"] = {0, 0, -981};
  root["materials"]["clay"].update({{"density", 2.0},
                                    {"lossFactor", 0.1},
                                    {"threshold", {{"mean", 0.01}, {"spread", 0.1}}},
                                    {"plastic", {{"yieldStrain", 0.01}, {"rate", 10}}}});
  root["tracks"] = {{{"target", "gravity.scale"}, {"keys", {{0, 1}, {1, 2}}}},
                    {{"target", "gravity"}, {"keys", {{0, {0, 0, -981}}}}},
                    {{"target", "stiffness.scale"}, {"keys", {{0, 1}}}},
                    {{"target", "collider.thing.position"}, {"keys", {{0, {0, 0, -9}}}}},
                    {{"target", "collider.thing.rotation"}, {"keys", {{0, {0, 0, 0}}}}}};
  root["solver"] = {{"safety", 0.5},
                    {"seed", 1},
                    {"contact", {{"stiffnessScale", 1}, {"dampingRatio", 0.1}, {"friction", 0.1}}}};
  root["output"] = {{"fps", 24}, {"duration", 1}};
  root["view"] = {
      {"camera",
       {{"position", {9, 9, 9}}, {"target", {0, 0, 0}}, {"fieldOfView", 30}, {"aperture", 0}, {"focus", 9}}}};
  return root;
}

/// Every `stride`th of all numbers with all values that are tried.
void tryNumbers(std::size_t stride) {
  std::size_t refused = 0, done = 0, trial = 0;
  for (std::size_t kind = 0; kind < std::size(kPartKinds); ++kind) {
    const json whole =
        everyKeyOf(sceneOf(kPartKinds[kind], kColliderKinds[kind % std::size(kColliderKinds)]));
    REQUIRE(triedOut(whole.dump()) == "");
    std::vector<std::string> places;
    collect(whole, "", places);
    CHECK(places.size() > 40);
    for (const std::string& place : places) {
      // What scenes of all kinds have is tried with one.
      const bool ofKind = place.starts_with("/parts") || place.starts_with("/environment/colliders");
      if (kind > 0 && !ofKind) continue;
      for (const double value : kTries) {
        if (trial++ % stride != 0) continue;
        json changed = whole;
        changed[json::json_pointer(place)] = value;
        INFO(place << " = " << value);
        const std::string answer = triedOut(changed.dump());
        (answer.empty() ? done : refused) += 1;
        // What is far out of all bounds is refused where it stands.
        if (std::abs(value) >= 1e30) CHECK(answer.starts_with("s:"));
      }
    }
  }
  // Neither is rare: about half of the values are out of most bounds.
  CHECK(4 * done > trial / stride);
  CHECK(4 * refused > trial / stride);
}

// Eleven and eight values have no common divisor, so that all values come.
TEST_CASE("whatever a number of a scene is, the scene is built or refused with a reason") {
  tryNumbers(11);
}

TEST_CASE("whatever any number of a scene is, the scene is built or refused with a reason", "[large]") {
  tryNumbers(1);
}

TEST_CASE("every kind of part and obstacle at every corner of its bounds is built or refused") {
  const std::uint64_t seed = 14;
  std::uint64_t draw = 0;
  const auto pick = [&](std::size_t count) {
    return std::min(count - 1,
                    static_cast<std::size_t>(sim::uniformAt(seed, draw++) * static_cast<double>(count)));
  };
  const double values[] = {1e-6, 1e-3, 0.5, 1.0, 40.0, 1e3, 1e6, 0.0};
  for (int trial = 0; trial < 200; ++trial) {
    json whole = everyKeyOf(
        sceneOf(kPartKinds[pick(std::size(kPartKinds))], kColliderKinds[pick(std::size(kColliderKinds))]));
    std::vector<std::string> places;
    collect(whole, "", places);
    for (std::size_t change = 0; change < 1 + pick(4); ++change)
      whole[json::json_pointer(places[pick(places.size())])] = values[pick(std::size(values))];
    INFO(whole.dump());
    static_cast<void>(triedOut(whole.dump()));
  }
}

TEST_CASE(
    "a number out of its bounds is told of by its place, in files, settings and scenes of the window alike") {
  const auto answerOf = [](const std::string& text, const std::vector<std::string>& settings = {}) {
    const auto file = modeling::parseScene(text, "s", settings);
    return file.ok() ? "" : file.problem().line();
  };
  CHECK(answerOf(tests::replaced(tests::kPlainScene, "[4, 2, 2]", "[4, 1e308, 2]")) ==
        "s:5:71: size holds 1e+308; give a number from 1e-06 to 1e+06");
  CHECK(answerOf(tests::kPlainScene, {"output.fps=0"}) ==
        "--set output.fps:1:1: fps holds 0; give a number from 0.001 to 1e+06");
  const std::string track =
      R"("tracks": [{"target": "stiffness.scale", "keys": [[0, 1], [1, 1e7]]}], "parts")";
  CHECK(answerOf(tests::replaced(tests::kPlainScene, "\"parts\"", track)) ==
        "s:4:65: keys holds 1e+07; give a number from 0 to 1e+06");

  Scene scene = sceneOf(kPartKinds[0], kColliderKinds[0]);
  scene.parts[0].worldFromPart.position.x() = 1e300;
  scene.environment.colliders[0].friction = std::numeric_limits<double>::quiet_NaN();
  const auto problem = modeling::numberOutOfRange(scene);
  REQUIRE(problem);
  CHECK(problem->place == "parts[0].worldFromPart.position[0]");
  CHECK_FALSE(modeling::build(scene, folder()).ok());
  modeling::keepNumbersInRange(scene);
  CHECK_FALSE(modeling::numberOutOfRange(scene));
  CHECK(scene.parts[0].worldFromPart.position.x() == 1e6);
  CHECK(scene.environment.colliders[0].friction == 0.0);
  CHECK(modeling::parseScene(modeling::writeScene(scene), "s").ok());
}

TEST_CASE("cells far smaller than their part are refused by their number, before memory is used") {
  for (const char* part : kPartKinds) {
    if (std::string(part).find("network") != std::string::npos) continue;
    json whole = everyKeyOf(sceneOf(part, kColliderKinds[0]));
    const bool mesh = whole["parts"][0]["kind"] == "mesh";
    (mesh ? whole["parts"][0]["cellSize"] : whole["parts"][0]["resolution"]["cellSize"]) = 1e-5;
    const std::string answer = triedOut(whole.dump());
    INFO(answer);
    CHECK(answer.find("cells") != std::string::npos);
    CHECK(answer.find_first_of("0123456789", answer.find(' ')) != std::string::npos);
  }
}

}  // namespace
