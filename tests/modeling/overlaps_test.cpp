// What begins inside something else is told of before it is pushed out.
#include "modeling/preflight/overlaps.h"

#include <filesystem>

#include <catch2/catch.hpp>

#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"

namespace {

using modeling::Overlap;

std::vector<Overlap> overlapsOf(const modeling::Scene& scene, const std::filesystem::path& folder = {}) {
  auto built = modeling::build(scene, folder);
  INFO((built ? "" : built.problem().line()));
  REQUIRE(built.ok());
  const auto simulation = sim::Simulation::create(built->network, built->conditions.environment,
                                                  built->conditions.tracks, built->conditions.settings);
  INFO((simulation ? "" : simulation.problem().line()));
  REQUIRE(simulation.ok());
  return modeling::findOverlaps(**simulation, built->conditions.environment, built->conditions.tracks);
}

modeling::Scene sceneOf(const std::string& parts, const std::string& more = "") {
  const std::string text = R"({"smithereens": 1, "materials": {"clay": {"youngsModulus": 1e8}}, "parts": [)" +
                           parts + "]" + more + "}";
  auto file = modeling::parseScene(text, "s");
  INFO((file ? "" : file.problem().line()));
  REQUIRE(file.ok());
  return file->scene;
}

/// 4 x 4 x 1 cm, in cells of half a centimetre.
std::string slab(const std::string& name, const std::string& position, const std::string& more = "") {
  return R"({"name": ")" + name + R"(", "kind": "slab", "material": "clay", "size": [4, 4, 1],
    "worldFromPart": {"position": )" +
         position + "}" + more + "}";
}

const std::string kFloor = R"(, "environment": {"colliders": [{"name": "floor", "kind": "floor"}]})";

TEST_CASE("a part that begins below the floor is told of, with how deep and the way out") {
  for (const double depth : {0.02, 0.1, 0.5}) {
    const auto found = overlapsOf(sceneOf(slab("tile", "[0, 0, " + std::to_string(-depth) + "]"), kFloor));
    REQUIRE(found.size() == 1);
    CHECK(found[0].part == "tile");
    CHECK(found[0].other == "floor");
    CHECK(found[0].obstacle);
    CHECK(found[0].depth == Approx(depth));
    CHECK((found[0].wayOut - depth * sim::Vec3::UnitZ()).norm() < 1e-9);
    CHECK_THAT(found[0].text(), Catch::Contains("move it by (0, 0, "));
  }
}

TEST_CASE("what stands on something, or hovers above it, overlaps nothing") {
  CHECK(overlapsOf(sceneOf(slab("tile", "[0, 0, 0]"), kFloor)).empty());
  CHECK(overlapsOf(sceneOf(slab("tile", "[0, 0, 0.001]"), kFloor)).empty());
  CHECK(overlapsOf(sceneOf(slab("below", "[0, 0, 0]") + "," + slab("above", "[0, 0, 1]"), kFloor)).empty());
  CHECK(overlapsOf(sceneOf(slab("left", "[0, 0, 0]") + "," + slab("right", "[4, 0, 0]"), kFloor)).empty());
  // Their boxes meet, and they do not.
  CHECK(overlapsOf(sceneOf(slab("a", "[0, 0, 0]") +
                           R"(,{"name": "b", "kind": "slab", "material": "clay", "size": [1, 1, 4],
    "worldFromPart": {"position": [2.8, 0, 0.2], "rotation": [0, 20, 0]}})"))
            .empty());
}

TEST_CASE("each kind of obstacle is looked into, where it is at the start and if it is there then") {
  const auto with = [&](const std::string& obstacle, const std::string& more = "") {
    return overlapsOf(
        sceneOf(slab("tile", "[0, 0, 0]"),
                R"(, "environment": {"colliders": [{"name": "it", )" + obstacle + "}]}" + more));
  };
  const auto box = with(R"("kind": "box", "halfSize": [5, 5, 1], "position": [0, 0, -0.8])");
  REQUIRE(box.size() == 1);
  CHECK(box[0].depth == Approx(0.2));
  const auto ball = with(R"("kind": "sphere", "radius": 1, "position": [0, 0, -0.9])");
  REQUIRE(ball.size() == 1);
  CHECK(ball[0].depth == Approx(0.1));
  CHECK(with(R"("kind": "cylinder", "radius": 1, "halfHeight": 1, "position": [0, 0, -0.7])").size() == 1);
  const std::string open =
      R"("surface": {"points": [[-9, -9, 0.2], [9, -9, 0.2], [0, 9, 0.2]], "triangles": [[0, 1, 2]]})";
  CHECK(with(R"("kind": "mesh", "thickness": 0.1, )" + open).empty());  // between two rows of nodes
  CHECK(with(R"("kind": "mesh", "thickness": 0.6, )" + open).size() == 1);
  CHECK(with(R"("kind": "box", "halfSize": [5, 5, 1], "active": [0.5, 1])").empty());
  CHECK(with(R"("kind": "box", "halfSize": [5, 5, 1])",
             R"(, "tracks": [{"target": "collider.it.position", "keys": [[0, [0, 0, -9]], [1, [0, 0, 0]]]}])")
            .empty());
}

TEST_CASE("what is held inside an obstacle is meant so") {
  const std::string held = R"(, "hold": [{"min": [-9, -9, -9], "max": [9, 9, 9]}])";
  CHECK(overlapsOf(sceneOf(slab("clamped", "[0, 0, -0.5]", held), kFloor)).empty());
}

TEST_CASE("two parts in one place are told of, once") {
  const auto same = overlapsOf(sceneOf(slab("a", "[0, 0, 0]") + "," + slab("b", "[0, 0, 0]")));
  REQUIRE(same.size() == 1);
  CHECK_FALSE(same[0].obstacle);
  CHECK(same[0].depth == Approx(0.5));  // the middle of a slab of 1 cm
  CHECK_THAT(same[0].text(), Catch::Contains("or glue the two"));

  const auto half = overlapsOf(sceneOf(slab("a", "[0, 0, 0]") + "," + slab("b", "[0, 0, 0.7]")));
  REQUIRE(half.size() == 1);
  CHECK(half[0].depth == Approx(0.3));
  // Moved so they are apart, and touch.
  CHECK(half[0].wayOut.norm() == Approx(0.3));
  CHECK(same[0].wayOut.norm() == Approx(1.0));
}

TEST_CASE("a thing inside another is told of, however fine its cells") {
  const std::string pebble =
      R"({"name": "pebble", "kind": "slab", "material": "clay", "size": [0.2, 0.2, 0.2],
    "resolution": {"cellSize": 0.2}, "worldFromPart": {"position": [0.6, 0.6, 0.6]}})";
  const auto found = overlapsOf(sceneOf(slab("tile", "[0, 0, 0]") + "," + pebble));
  REQUIRE(found.size() == 1);
  CHECK(found[0].depth > 0.2);
}

TEST_CASE("parts that are glued may lie in each other") {
  CHECK(overlapsOf(sceneOf(slab("a", "[0, 0, 0]") + "," + slab("b", "[0, 0, 0.7]"),
                           R"(, "glue": [{"a": "b", "b": "a", "reach": 0.3}])"))
            .empty());
}

TEST_CASE(
    "of the gallery only the tipsy table has things that begin inside others: its vases, which the teapot "
    "surrounds") {
  const std::filesystem::path folder = SMITHEREENS_SOURCE_DIR "/resources/scenes";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (!entry.path().string().ends_with(".scene.json")) continue;
    const auto file = modeling::loadScene(entry.path());
    REQUIRE(file.ok());
    const bool vases = entry.path().filename() == "tipsy-table.scene.json";
    std::size_t found = 0;
    for (const Overlap& overlap : overlapsOf(file->scene, folder)) {
      INFO(entry.path() << ": " << overlap.text());
      CHECK(vases);
      CHECK_THAT(overlap.part, Catch::EndsWith("vase"));
      CHECK_THAT(overlap.other, Catch::StartsWith("teapot"));
      ++found;
    }
    CHECK(found == (vases ? 3 : 0));
  }
}

}  // namespace
