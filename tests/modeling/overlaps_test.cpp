#include "modeling/preflight/overlaps.h"

#include <cmath>
#include <filesystem>
#include <numbers>

#include <catch2/catch.hpp>

#include "modeling/scene/scene_file.h"
#include "sim/network/network.h"

namespace {

using modeling::Overlap;
using sim::Vec3;

const std::filesystem::path kScenes = std::filesystem::path(SMITHEREENS_SOURCE_DIR) / "resources" / "scenes";

/// Of these parts and colliders (JSON, without the brackets).
modeling::BuiltScene builtOf(const std::string& parts, const std::string& colliders,
                             const std::string& more = "") {
  const std::string text =
      R"({"smithereens": 1, "name": "overlaps", "materials": {"c": {"preset": "tipsy-turvy-ceramic"}},
    "parts": [)" +
      parts + R"(], "environment": {"colliders": [)" + colliders + "]}" + more + "}";
  const auto scene = modeling::parseScene(text, "overlaps");
  if (!scene) FAIL(scene.problem().line());
  auto built = modeling::build(scene->scene, "");
  if (!built) FAIL(built.problem().line());
  return std::move(built).value();
}

std::string list(const Vec3& v) {
  return "[" + std::to_string(v.x()) + ", " + std::to_string(v.y()) + ", " + std::to_string(v.z()) + "]";
}

/// About its position; z from there on.
std::string slab(const std::string& name, const Vec3& size, const Vec3& at, double cell = 0.5,
                 const std::string& more = "") {
  return R"({"name": ")" + name + R"(", "kind": "slab", "material": "c", "size": )" + list(size) +
         R"(, "resolution": {"cellSize": )" + std::to_string(cell) + R"(}, "worldFromPart": {"position": )" +
         list(at) + "}" + more + "}";
}

const char* const kFloor = R"({"name": "floor", "kind": "floor"})";

std::vector<Overlap> overlapsOf(const std::string& parts, const std::string& colliders,
                                const std::string& more = "") {
  return modeling::findOverlaps(builtOf(parts, colliders, more));
}

/// What is left when each mend is made in the scene as it is told.
std::vector<Overlap> mended(modeling::BuiltScene built, const std::vector<Overlap>& overlaps) {
  for (const Overlap& overlap : overlaps) {
    REQUIRE(overlap.mend);
    for (modeling::Part& part : built.scene.parts) {
      if (part.name == overlap.mend->part) part.worldFromPart.position += overlap.mend->move;
    }
  }
  auto again = modeling::build(built.scene, "");
  REQUIRE(again);
  return modeling::findOverlaps(*again);
}

TEST_CASE("a slab in the floor is told of with its depth, and lies free by the move that is told") {
  for (const double depth : {0.005, 0.02, 0.1, 0.5}) {
    const auto built = builtOf(slab("tile", {6, 6, 1}, {0, 0, -depth}), kFloor);
    const auto overlaps = modeling::findOverlaps(built);
    REQUIRE(overlaps.size() == 1);
    CHECK(overlaps[0].kind == Overlap::Kind::partInObstacle);
    CHECK(overlaps[0].part == "tile");
    CHECK(overlaps[0].other == "floor");
    CHECK(overlaps[0].depth == Approx(depth));
    CHECK(overlaps[0].at.z() == Approx(-depth));
    REQUIRE(overlaps[0].mend);
    CHECK((overlaps[0].mend->move - Vec3(0, 0, depth)).norm() < 1e-9);
    CHECK(mended(built, overlaps).empty());
  }
}

TEST_CASE("an overlap is told of in a sentence that says how to mend it") {
  const auto deep = overlapsOf(slab("tile", {6, 6, 1}, {0, 0, -0.1}), kFloor);
  REQUIRE(deep.size() == 1);
  const std::string text = modeling::sentence(deep[0]);
  CHECK(text.starts_with("the part \"tile\" begins 0.1 cm inside the obstacle \"floor\", deepest at ("));
  CHECK(text.ends_with("; move \"tile\" up by 0.1 cm"));
  // A name may hold anything, but a line stays a line.
  Overlap odd = deep[0];
  odd.part = "a\nb\x1b[2J";
  odd.mend->part = odd.part;
  CHECK(modeling::sentence(odd).find_first_of("\n\x1b") == std::string::npos);
  // To three digits, but never too short.
  odd.mend->move = {0.0, -0.123401, 0.0};
  CHECK(modeling::sentence(odd).find("by 0.124 cm along -y") != std::string::npos);
}

TEST_CASE("what lies on the floor, hovers over it or beside an obstacle is free") {
  CHECK(overlapsOf(slab("a", {6, 6, 1}, {0, 0, 0}), kFloor).empty());
  CHECK(overlapsOf(slab("a", {6, 6, 1}, {0, 0, 1e-6}), kFloor).empty());
  // Turned by what no binary number is, so that corners stand on the floor but for rounding.
  const std::string turned = R"({"name": "a", "kind": "slab", "material": "c", "size": [3, 3, 1],
    "resolution": {"cellSize": 0.5}, "worldFromPart": {"position": [0, 0, 3], "rotation": [0, 90, 0]}})";
  CHECK(overlapsOf(turned, R"({"name": "floor", "kind": "floor", "position": [0, 0, 1.5]})").empty());
  const std::string box = R"({"name": "box", "kind": "box", "halfSize": [1, 1, 1], "position": [4, 0, 1]})";
  CHECK(overlapsOf(slab("a", {6, 6, 2}, {0, 0, 0}), box).empty());
  // A thousandth of a millimetre is a gap.
  CHECK(overlapsOf(slab("a", {6, 6, 2}, {-0.0001, 0, 0}), box).empty());
}

TEST_CASE("boxes, balls and cylinders that a part begins in are told of, and the told move frees") {
  const struct {
    const char* text;
    double depth;
  } obstacles[] = {
      {R"({"name": "o", "kind": "box", "halfSize": [1, 1, 1], "position": [3.8, 0, 1]})", 0.2},
      {R"({"name": "o", "kind": "sphere", "radius": 2, "position": [0, 0, 3.7]})", 0.3},
      {R"({"name": "o", "kind": "cylinder", "radius": 1, "halfHeight": 1, "position": [0, 0, 2.75]})", 0.25},
  };
  for (const auto& obstacle : obstacles) {
    INFO(obstacle.text);
    const auto built = builtOf(slab("a", {6, 6, 2}, {0, 0, 0}), obstacle.text);
    const auto overlaps = modeling::findOverlaps(built);
    REQUIRE(overlaps.size() == 1);
    // A node stands where each is deepest.
    CHECK(overlaps[0].depth == Approx(obstacle.depth));
    CHECK(mended(built, overlaps).empty());
  }
}

TEST_CASE("an obstacle that is not there yet, or is taken elsewhere by its track, is no overlap") {
  const std::string tile = slab("a", {6, 6, 2}, {0, 0, 0});
  const std::string ball = R"({"name": "ball", "kind": "sphere", "radius": 2, "position": [0, 0, 3])";
  CHECK(overlapsOf(tile, ball + "}").size() == 1);
  CHECK(overlapsOf(tile, ball + R"(, "active": [0.5, 1]})").empty());
  const std::string track = R"(, "tracks": [{"target": "collider.ball.position",
    "keys": [[0, [0, 0, 9]], [1, [0, 0, 3]]]}])";
  CHECK(overlapsOf(tile, ball + "}", track).empty());
}

TEST_CASE("an obstacle thinner than cells that stands between a part's nodes is told of") {
  const std::string needle =
      R"({"name": "needle", "kind": "cylinder", "radius": 0.05, "halfHeight": 5, "position": [0.25, 0.25, 0]})";
  const auto built = builtOf(slab("a", {6, 6, 2}, {0, 0, 0}), needle);
  const auto overlaps = modeling::findOverlaps(built);
  REQUIRE(overlaps.size() == 1);
  CHECK(overlaps[0].kind == Overlap::Kind::obstacleInPart);
  CHECK(overlaps[0].depth == Approx(1.0).margin(0.1));  // half the slab's height, to the distance of samples
  CHECK(mended(built, overlaps).empty());
}

TEST_CASE("two slabs in one place, half through each other, crossed or one within the other overlap") {
  const struct {
    Vec3 size, at;
    double cell;
    double depth;
  } others[] = {
      {{4, 4, 1}, {0, 0, 0.1}, 0.5, 1.0},        // the same place
      {{4, 4, 1}, {0, 0, 0.6}, 0.5, 0.5},        // half through
      {{4, 4, 1}, {3.8, 0, 0.1}, 0.5, 0.2},      // a little, sideways
      {{4, 4, 1}, {0, 0, 1.05}, 0.5, 0.05},      // half a millimetre
      {{8, 0.2, 0.2}, {0, 0, 0.43}, 0.2, 0.53},  // a rod through it
      {{1, 1, 0.5}, {0, 0, 0.3}, 0.5, 0.7},      // within
  };
  for (const auto& other : others) {
    INFO(other.at.transpose() << ", " << other.size.transpose());
    const auto built = builtOf(
        slab("a", {4, 4, 1}, {0, 0, 0.1}) + "," + slab("b", other.size, other.at, other.cell), kFloor);
    const auto overlaps = modeling::findOverlaps(built);
    REQUIRE(overlaps.size() == 1);
    CHECK(overlaps[0].kind == Overlap::Kind::parts);
    CHECK(overlaps[0].part == "a");
    CHECK(overlaps[0].other == "b");
    // The shortest way apart, of those that are tried.
    CHECK(overlaps[0].depth == Approx(other.depth).margin(0.1 * other.depth));
    CHECK(mended(built, overlaps).empty());
    REQUIRE(overlaps[0].mend);
    CHECK(overlaps[0].mend->move.z() >= 0.0);  // into the floor is no help
  }
}

TEST_CASE("parts of one cell's thickness, whose nodes all lie on the surface, overlap too") {
  const auto overlaps =
      overlapsOf(slab("a", {4, 4, 0.5}, {0, 0, 0}) + "," + slab("b", {4, 4, 0.5}, {0.13, 0.07, 0}), "");
  REQUIRE(overlaps.size() == 1);
  CHECK(overlaps[0].depth == Approx(0.5));
}

TEST_CASE("parts that share a face, touch at an edge or stand a hair apart do not overlap") {
  for (const Vec3& at :
       {Vec3(0, 0, 1), Vec3(4, 0, 0), Vec3(4, 4, 0), Vec3(4, 4, 1), Vec3(0, 0, 1.0001), Vec3(1.7, 0.3, 1)}) {
    INFO(at.transpose());
    CHECK(overlapsOf(slab("a", {4, 4, 1}, {0, 0, 0}) + "," + slab("b", {4, 4, 1}, at, 0.4), "").empty());
  }
}

/// A straight segment of a profile, as the cubic that it is.
std::string line(double r0, double z0, double r1, double z1) {
  std::string text = "[";
  for (int i = 0; i < 4; ++i) {
    const double share = i / 3.0;
    text += (i > 0 ? ", [" : "[") + std::to_string(r0 + share * (r1 - r0)) + ", " +
            std::to_string(z0 + share * (z1 - z0)) + "]";
  }
  return text + "]";
}

/// A cup about the z axis of these outer radius and height, wall and bottom 0.5 thick.
std::string cup(const std::string& name, double radius, double height, const Vec3& at, int around = 24) {
  const double inner = radius - 0.5;
  return R"({"name": ")" + name + R"(", "kind": "revolution", "material": "c", "correspondence": "segments",
    "outside": [)" +
         line(radius, height, radius, 0) + ", " + line(radius, 0, 0, 0) + R"(], "inside": [)" +
         line(inner, height, inner, 0.5) + ", " + line(inner, 0.5, 0, 0.5) +
         R"(], "resolution": {"cellSize": 0.5,
    "counts": [)" +
         std::to_string(around) + R"(, null, 1]}, "worldFromPart": {"position": )" + list(at) + "}}";
}

TEST_CASE(
    "a cup in a cup is free as long as they do not touch, and overlaps where it goes through the bottom") {
  const std::string outer = cup("outer", 4, 5, {0, 0, 0});
  CHECK(overlapsOf(outer + "," + cup("inner", 3, 5, {0, 0, 0.6}), "").empty());
  CHECK(overlapsOf(outer + "," + cup("inner", 3, 5, {0, 0, 0.5}), "").empty());  // stands on its bottom
  // And fills it, whether or not the facets of both are the same.
  for (const int around : {24, 32, 40, 48})
    CHECK(overlapsOf(outer + "," + cup("inner", 3.5, 5, {0, 0, 0.5}, around), "").empty());
  const auto built = builtOf(outer + "," + cup("inner", 3, 5, {0, 0, 0.3}), "");
  const auto overlaps = modeling::findOverlaps(built);
  REQUIRE(overlaps.size() == 1);
  CHECK(overlaps[0].depth == Approx(0.2).margin(0.01));
  CHECK(mended(built, overlaps).empty());
}

TEST_CASE("glued parts are no overlap, however they are glued") {
  const std::string both = slab("a", {4, 4, 1}, {0, 0, 0}) + "," + slab("b", {1, 1, 4}, {0, 0, 0.5});
  CHECK(overlapsOf(both, "").size() == 1);
  CHECK(overlapsOf(both, "", R"(, "glue": [{"a": "b", "b": "a", "reach": 0.3}])").empty());
}

TEST_CASE("what is glued moves together out of an obstacle") {
  const auto overlaps =
      overlapsOf(slab("a", {4, 4, 1}, {0, 0, -0.2}) + "," + slab("b", {4, 4, 1}, {0, 0, 0.8}), kFloor,
                 R"(, "glue": [{"a": "b", "b": "a", "reach": 0.2}])");
  REQUIRE(overlaps.size() == 1);
  CHECK(overlaps[0].part == "a");
  REQUIRE(overlaps[0].mend);
  CHECK(overlaps[0].mend->glued);
  CHECK(modeling::sentence(overlaps[0]).ends_with("move \"a\" and what is glued to it up by 0.2 cm"));
}

TEST_CASE("what is held in place may stand in an obstacle") {
  const std::string held = R"(, "hold": [{"min": [-9, -9, -9], "max": [9, 9, 9]}])";
  CHECK(overlapsOf(slab("a", {4, 4, 1}, {0, 0, -0.5}, 0.5, held), kFloor).empty());
}

TEST_CASE("the gallery's scenes begin free") {
  std::vector<std::string> crowded;
  for (const auto& entry : std::filesystem::directory_iterator(kScenes)) {
    if (!entry.path().string().ends_with(".scene.json")) continue;
    INFO(entry.path());
    const auto scene = modeling::loadScene(entry.path());
    REQUIRE(scene.ok());
    const auto built = modeling::build(scene->scene, kScenes);
    REQUIRE(built.ok());
    for (const Overlap& overlap : modeling::findOverlaps(*built)) {
      INFO(modeling::sentence(overlap));
      crowded.push_back(overlap.part + ", " + overlap.other);
    }
  }
  CHECK(crowded.empty());
}

}  // namespace
