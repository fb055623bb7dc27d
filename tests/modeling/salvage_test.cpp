#include "modeling/scene/salvage.h"

#include <catch2/catch.hpp>

#include "modeling/scene/scene_file.h"

namespace {

constexpr std::string_view kCups = R"({
  "smithereens": 1,
  "name": "cups",
  "materials": {"clay": {"density": 2.4}, "glue": {"density": 1}},
  "parts": [
    {"name": "one", "kind": "slab", "material": "clay", "size": [1, 1, 1]},
    {"name": "two", "kind": "slab", "material": "clay", "size": [2, 2, 2]},
    {"name": "three", "kind": "slab", "material": "clay", "size": [3, 3, 3]}
  ],
  "glue": [{"a": "one", "b": "two", "reach": 0.1}, {"a": "two", "b": "three", "reach": 0.1}],
  "environment": {"gravity": [0, 0, -981], "colliders": [{"name": "floor", "kind": "floor"},
                                                          {"name": "ball", "kind": "sphere", "radius": 2}]}
})";

std::string with(std::string_view from, std::string_view to) {
  std::string text(kCups);
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

modeling::SalvagedScene salvage(const std::string& text) {
  const auto salvaged = modeling::salvageScene(text, "cups");
  REQUIRE(salvaged);
  return *salvaged;
}

std::vector<std::string> partsOf(const modeling::Scene& scene) {
  std::vector<std::string> names;
  for (const modeling::Part& part : scene.parts) names.push_back(part.name);
  return names;
}

using Names = std::vector<std::string>;

TEST_CASE("A whole scene is read as always") {
  const auto scene = modeling::parseScene(kCups, "cups");
  REQUIRE(scene);
  const modeling::SalvagedScene salvaged = salvage(std::string(kCups));
  CHECK(salvaged.faults.empty());
  CHECK(salvaged.scene == scene->scene);
}

TEST_CASE("A part with a fault is left out, with the gluings that name it") {
  const modeling::SalvagedScene salvaged = salvage(with("[2, 2, 2]", "[2, -2, 2]"));
  CHECK(partsOf(salvaged.scene) == Names{"one", "three"});
  CHECK(salvaged.scene.glue.empty());
  REQUIRE(salvaged.faults.size() == 3);
  CHECK(salvaged.faults[0].place == "cups:7:69");
}

TEST_CASE("A collider with a fault is left out, the others and gravity stay") {
  const modeling::SalvagedScene salvaged = salvage(with("\"radius\": 2", "\"radiu\": 2"));
  REQUIRE(salvaged.scene.environment.colliders.size() == 1);
  CHECK(salvaged.scene.environment.colliders[0].name == "floor");
  CHECK(salvaged.faults.size() == 1);
  CHECK(salvaged.scene.parts.size() == 3);
}

TEST_CASE("An unknown section is left out") {
  const modeling::SalvagedScene salvaged = salvage(with("\"name\": \"cups\"", "\"nme\": \"cups\""));
  CHECK(salvaged.scene.parts.size() == 3);
  CHECK(salvaged.faults.size() == 1);
}

TEST_CASE("A scene cut off anywhere behind its first part gives the parts before the cut") {
  const std::string whole(kCups);
  const std::size_t first = whole.find("[1, 1, 1]}") + 10;
  for (std::size_t length = first; length < whole.size(); ++length) {
    INFO("cut to " << length);
    const auto salvaged = modeling::salvageScene(whole.substr(0, length), "cups");
    REQUIRE(salvaged);
    CHECK_FALSE(salvaged->faults.empty());
    const std::size_t whole3 = whole.find("[3, 3, 3]}") + 10;
    CHECK(salvaged->scene.parts.size() >= (length >= whole3 ? 3U : 1U));
    CHECK(modeling::checkScene(salvaged->scene));
  }
}

TEST_CASE("What is no scene is a problem") {
  for (const char* text :
       {"", "{", "[]", "nonsense", "{\"smithereens\": 7, \"parts\": []}", "{\"parts\": []}"})
    CHECK_FALSE(modeling::salvageScene(text, "file"));
}

}  // namespace
