#include <filesystem>
#include <fstream>
#include <numbers>

#include <catch2/catch.hpp>

#include "modeling/scene/build.h"
#include "modeling/scene/resources.h"
#include "modeling/scene/scene_file.h"
#include "tests/modeling/scene_examples.h"

namespace {

using modeling::BuiltScene;
using sim::Vec3;
using tests::kPlainScene;
using tests::replaced;

modeling::SceneFile fileOf(const std::string& text, const std::vector<std::string>& settings = {}) {
  sim::Result<modeling::SceneFile> file = modeling::parseScene(text, "s", settings);
  if (!file) FAIL(file.problem().line());
  return std::move(file).value();
}

BuiltScene built(const std::string& text, const std::vector<std::string>& settings = {}) {
  sim::Result<BuiltScene> result =
      modeling::build(fileOf(text, settings).scene, SMITHEREENS_SOURCE_DIR "/tests/data/lammps-bar");
  if (!result) FAIL(result.problem().line());
  CHECK_FALSE(result->network.validate());
  return std::move(result).value();
}

std::string problemOf(const std::string& text, const std::vector<std::string>& settings = {}) {
  const modeling::SceneFile file = fileOf(text, settings);
  const auto result = modeling::build(file.scene, SMITHEREENS_SOURCE_DIR "/tests/data/lammps-bar");
  return result.ok() ? "" : file.located(result.problem()).line();
}

Vec3 momentum(const sim::Network& network) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < network.nodeCount(); ++i) sum += network.masses[i] * network.velocities[i];
  return sum;
}

double mass(const sim::Network& network) {
  double sum = 0.0;
  for (const double share : network.masses) sum += share;
  return sum;
}

TEST_CASE("a part is scaled, then turned, then moved") {
  const BuiltScene scene = built(kPlainScene, {"parts.brick.worldFromPart.position=[10,0,5]",
                                               "parts.brick.worldFromPart.rotation=[0,0,90]",
                                               "parts.brick.worldFromPart.scale=[2,1,1]"});
  Eigen::AlignedBox3d box;
  for (const Vec3& position : scene.network.positions) box.extend(position);
  // 4 x 2 x 2, on z = 0, becomes 8 long in x, which turns into y.
  CHECK((box.min() - Vec3(9, -4, 5)).norm() < 1e-12);
  CHECK((box.max() - Vec3(11, 4, 7)).norm() < 1e-12);
  CHECK(mass(scene.network) == Approx(2.4 * 32.0));
}

TEST_CASE("three angles turn about the fixed axes x, then y, then z") {
  const modeling::Rotation rotation{Vec3(90, 0, 90)};
  CHECK((rotation.quaternion() * Vec3::UnitY() - Vec3::UnitZ()).norm() < 1e-12);
  CHECK((rotation.quaternion() * Vec3::UnitX() - Vec3::UnitY()).norm() < 1e-12);
  const modeling::Rotation same{Eigen::Vector4d(1, 1, 1, 1)};
  CHECK(same.quaternion().angularDistance(rotation.quaternion()) < 1e-12);
}

TEST_CASE("spinning gives a part no push, whatever its shape") {
  const std::string wedge = replaced(
      kPlainScene, R"("kind": "slab", "material": "clay", "size": [4, 2, 2])",
      R"("kind": "revolution", "material": "clay", "turnAngle": 120, "outside": [[[3, 0], [5, 4]]], "inside": [[[2, 0], [2, 4]]])");
  const BuiltScene still = built(wedge, {"parts.brick.velocity=[1,2,3]"});
  const BuiltScene spinning =
      built(wedge, {"parts.brick.velocity=[1,2,3]", "parts.brick.angularVelocity=[5,-7,9]"});
  const double scale = mass(still.network) * 50.0;  // g cm/s: what its nodes have one by one
  CHECK((momentum(spinning.network) - momentum(still.network)).norm() < 1e-12 * scale);
  CHECK((spinning.network.velocities[0] - Vec3(1, 2, 3)).norm() > 1.0);
}

TEST_CASE("held regions are in the part's own coordinates") {
  const std::string text =
      replaced(kPlainScene, "\"size\": [4, 2, 2]",
               "\"size\": [4, 2, 2], \"resolution\": {\"cellSize\": 1}, \"hold\": [{\"min\": [-9, -9, -1], "
               "\"max\": [9, 9, 0.5]}], \"worldFromPart\": {\"position\": [0, 0, 100]}");
  const BuiltScene scene = built(text);
  std::size_t held = 0;
  for (std::size_t i = 0; i < scene.network.nodeCount(); ++i) {
    if (!std::isinf(scene.network.masses[i])) continue;
    ++held;
    CHECK(scene.network.positions[i].z() == 100.0);
  }
  CHECK(held == 15);
  CHECK(problemOf(replaced(text, "\"min\": [-9, -9, -1]", "\"min\": [-9, -9, 0.4]")).find("s:5:") == 0);
}

TEST_CASE("a network part keeps the file's nodes, their order and every digit") {
  const std::string bar =
      R"({"smithereens": 1, "parts": [{"name": "bar", "kind": "network", "file": "caseA.data",
    "format": "lammps", "bondTypes": {"1": {"stiffness": 1000, "restLength": 1, "damping": 0.5, "threshold": 0.05},
    "2": {"stiffness": 500}}}]})";
  const BuiltScene scene = built(bar);
  REQUIRE(scene.network.nodeCount() == 225);
  CHECK(scene.network.bondCount() == 1072);
  CHECK(scene.network.positions[1] == Vec3(1, 0.003108049841353322, 0));
  const sim::BondIndex edge = scene.network.findBond(0, 1);
  const sim::BondIndex diagonal = scene.network.findBond(0, 31);
  REQUIRE(edge != sim::kNone);
  REQUIRE(diagonal != sim::kNone);
  CHECK(scene.network.bond(edge).restLength == 1.0);
  CHECK(scene.network.bond(edge).damping == 0.5);
  CHECK(scene.network.thresholds[edge] == Approx(0.05));
  const double length = (scene.network.positions[31] - scene.network.positions[0]).norm();
  CHECK(scene.network.bond(diagonal).restLength == Approx(length).epsilon(1e-11));  // classes merge to 1e-12
  CHECK(std::isinf(scene.network.thresholds[diagonal]));

  const std::string missing =
      problemOf(replaced(bar, "\"2\": {\"stiffness\": 500}", "\"3\": {\"stiffness\": 500}"));
  CHECK(missing.find("caseA.data:") != std::string::npos);
  CHECK(missing.find("add \"2\" to bondTypes of the part \"bar\"") != std::string::npos);
  CHECK(problemOf(replaced(bar, "caseA.data", "caseB.data")).find("there is no such file") !=
        std::string::npos);
}

TEST_CASE("tracks find their materials and colliders by name, in whatever variants the network has") {
  const modeling::SceneFile file = fileOf(tests::kFullScene);
  std::vector<sim::Material> materials(4);
  materials[0].name = "clay";
  materials[1].name = "glass";
  materials[3].name = "clay";
  const modeling::Conditions conditions = modeling::conditionsOf(file.scene, materials);
  REQUIRE(conditions.tracks.size() == 7);
  CHECK(conditions.tracks[2].object == sim::kNone);
  CHECK(conditions.tracks[3].object == 0);
  CHECK(conditions.tracks[4].object == 3);
  CHECK(conditions.tracks[5].object == 2);  // the ball
  CHECK(conditions.tracks[6].keys[0].value.z() == std::numbers::pi / 2.0);
  CHECK(conditions.environment.colliders[1].shape == sim::ColliderShape(sim::BoxShape{Vec3(40, 30, 2)}));
  CHECK_FALSE(conditions.environment.colliders[2].visible);
  CHECK(conditions.settings.seed == 18446744073709551615U);
  CHECK(conditions.settings.contact.self);
}

TEST_CASE("glued parts are one component, and the report tells how") {
  const std::string text = R"({"smithereens": 1, "materials": {"clay": {}}, "parts": [
    {"name": "low", "kind": "slab", "material": "clay", "size": [4, 2, 2], "resolution": {"cellSize": 1}},
    {"name": "high", "kind": "slab", "material": "clay", "size": [4, 2, 2], "resolution": {"cellSize": 1},
     "worldFromPart": {"position": [0, 0, 2.1]}}],
    "glue": [{"a": "high", "b": "low", "reach": 0.2}]})";
  const BuiltScene scene = built(text);
  REQUIRE(scene.glue.size() == 1);
  CHECK(scene.glue[0].nodesMerged == 15);
  CHECK(scene.network.nodeCount() == 2 * 45 - 15);
  CHECK(scene.parts[1].nodes == 45);
  const std::string far = problemOf(text, {"glue[0].reach=0.05"});
  INFO(far);
  CHECK(far.starts_with("s:5:"));
}

TEST_CASE("what a shape refuses is told where the shape stands") {
  const std::string line =
      problemOf(replaced(kPlainScene, "[4, 2, 2]", "[4, 2, 2], \"resolution\": {\"cellSize\": 1e-4}"));
  INFO(line);
  CHECK(line.substr(0, 4) == "s:5:");
}

TEST_CASE("every preset is a sound material that says where its numbers come from") {
  const std::vector<std::string> names = modeling::presetNames();
  CHECK(names.size() >= 7);
  for (const std::string& name : names) {
    const auto preset = modeling::presetMaterial(name);
    INFO(name);
    REQUIRE(preset.ok());
    CHECK(validate(*preset).ok());
    CHECK_FALSE(preset->source.empty());
  }
}

}  // namespace
