#include "modeling/exchange/part_parameters.h"

#include <cmath>
#include <filesystem>

#include <catch2/catch.hpp>

#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "sim/surface/surface_mesh.h"
#include "tests/support/grid_network.h"

namespace {

constexpr const char* kSlabScene = R"({"smithereens": 1, "name": "slab",
  "materials": {"ceramic": {"preset": "tipsy-turvy-ceramic"}},
  "parts": [{"name": "slab", "kind": "slab", "material": "ceramic", "size": [8, 4, 1],
             "resolution": {"counts": [8, 4, 1]}}]})";

std::vector<modeling::FaceCoordinates> coordinatesOf(const modeling::PartParameters& parameters,
                                                     const sim::SurfaceMesh& mesh) {
  std::vector<modeling::FaceCoordinates> all;
  for (const auto& face : mesh.faces) all.push_back(parameters.textureCoordinates(mesh, face));
  return all;
}

TEST_CASE("texture coordinates of a slab are its own shares of length, whatever broke and was smoothed") {
  const auto file = modeling::parseScene(kSlabScene, "slab");
  REQUIRE(file);
  const auto built = modeling::build(file->scene, SMITHEREENS_SOURCE_DIR "/resources/scenes");
  REQUIRE(built);
  const auto parameters = modeling::PartParameters::create(
      file->scene, SMITHEREENS_SOURCE_DIR "/resources/scenes", built->network);
  REQUIRE(parameters);
  const auto& network = built->network;
  Eigen::AlignedBox3d box;
  for (const auto& position : network.positions) box.extend(position);
  sim::Snapshot moment = sim::momentAtRest(network);
  tests::breakBetween(network, box.min().x() + 3.4, moment);
  const sim::SurfaceMesh mesh = sim::SurfaceBuilder(network).build(moment);
  const auto coordinates = coordinatesOf(*parameters, mesh);
  std::size_t large = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const auto& face = mesh.faces[f];
    if (std::abs(mesh.normals[face.normals[0]].z()) < 0.9) continue;
    ++large;
    for (std::size_t c = 0; c < 4; ++c) {
      const sim::Vec3 share = (mesh.restPoints[face.points[c]] - box.min()).cwiseQuotient(box.sizes());
      CHECK(coordinates[f][c].x() == Approx(share.x()).margin(1e-5));
      CHECK(coordinates[f][c].y() == Approx(share.y()).margin(1e-5));
    }
  }
  CHECK(large > 2 * 8 * 4);
}

TEST_CASE("texture coordinates go on across the seam of a turned pot") {
  const std::filesystem::path folder(SMITHEREENS_SOURCE_DIR "/resources/scenes");
  const auto file = modeling::loadScene(folder / "teapot-drop.scene.json");
  REQUIRE(file);
  const auto built = modeling::build(file->scene, folder);
  REQUIRE(built);
  const auto parameters = modeling::PartParameters::create(file->scene, folder, built->network);
  REQUIRE(parameters);
  const auto moment = sim::momentAtRest(built->network);
  const sim::SurfaceMesh mesh = sim::SurfaceBuilder(built->network).build(moment);
  const auto coordinates = coordinatesOf(*parameters, mesh);
  float beyond = 0.0F;
  std::size_t narrow = 0;
  std::size_t wide = 0;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    if (built->network.partNames[mesh.faces[f].part] != "body") continue;
    for (std::size_t c = 0; c < 4; ++c) {
      // 56 columns around, but for the middle of the bottom, where angles mean less.
      const float around = std::abs(coordinates[f][c].x() - coordinates[f][0].x());
      if (coordinates[f][c].y() > 0.5F || coordinates[f][0].y() > 0.5F) continue;
      (around < 1.5F / 56.0F ? narrow : wide)++;
      beyond = std::max(beyond, coordinates[f][c].x());
    }
  }
  CHECK(wide == 0);
  CHECK(narrow > 1000);
  CHECK(beyond == Approx(1.0F).margin(1e-3));
}

TEST_CASE("texture coordinates are refused for a network of another scene") {
  const auto file = modeling::parseScene(kSlabScene, "slab");
  REQUIRE(file);
  const auto network = tests::gridNetwork(2, 2, 2);
  CHECK_FALSE(modeling::PartParameters::create(file->scene, ".", network));
}

}  // namespace
