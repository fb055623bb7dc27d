#include <filesystem>
#include <map>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "sim/dynamics/simulation.h"
#include "sim/surface/surface_mesh.h"

namespace {

using sim::LooseNodes;
using sim::SurfaceMesh;
using sim::Vec3;

/// By the divergence theorem, of each face the two triangles on either side of its diagonal.
std::map<sim::FragmentId, double> volumes(const SurfaceMesh& mesh) {
  std::map<sim::FragmentId, double> found;
  for (const auto& face : mesh.faces) {
    const auto corner = [&](unsigned c) { return mesh.points[face.points[c]]; };
    found[face.fragment] += corner(0).dot(corner(1).cross(corner(2)) + corner(2).cross(corner(3))) / 6.0;
  }
  return found;
}

double total(const std::map<sim::FragmentId, double>& volumes) {
  double sum = 0.0;
  for (const auto& [fragment, volume] : volumes) sum += volume;
  return sum;
}

/// Two parts of one material, the nodes of one not above those of the other.
constexpr const char* kStool = R"({
  "smithereens": 1, "name": "stool", "materials": {"clay": {"preset": "tipsy-turvy-ceramic"}},
  "parts": [
    {"name": "leg", "kind": "slab", "material": "clay", "size": [1.5, 1.5, 3], "resolution": {"counts": [2, 2, 4]},
     "worldFromPart": {"position": [0.2, -0.1, 1]}},
    {"name": "seat", "kind": "slab", "material": "clay", "size": [6, 6, 1], "resolution": {"counts": [20, 20, 2]}}
  ],
  "glue": [{"a": "leg", "b": "seat", "reach": 0.5}]
})";

TEST_CASE("of a glued part, the faces on the other are told from those that are seen") {
  const auto file = modeling::parseScene(kStool, "stool");
  if (!file) FAIL(file.problem().line());
  const auto built = modeling::build(file->scene, ".");
  if (!built) FAIL(built.problem().line());
  const SurfaceMesh mesh = sim::SurfaceBuilder(built->network).build(sim::momentAtRest(built->network));
  std::size_t covered = 0;
  double volume = 0.0;
  for (const auto& face : mesh.faces) {
    const std::string& part = built->network.partNames[face.part];
    double highest = 0.0;
    for (const std::uint32_t point : face.points) highest = std::max(highest, mesh.points[point].z());
    if (part == "seat") CHECK(highest <= 1.0);
    CHECK(face.covered == (part == "leg" && highest <= 1.0));
    covered += face.covered;
  }
  CHECK(covered == 4);
  for (const auto& [fragment, found] : volumes(mesh)) volume += found;
  CHECK(volume > 36.0 + 1.5 * 1.5 * 3.0 * 0.9);
}

struct Fall {
  const char* scene;
  double until;     ///< s
  double frames;    ///< a second
  double hastened;  ///< s: so long it falls before it is worth while to look
};

TEST_CASE("what is shown of a dish has the volume of the whole one in every frame while it breaks") {
  for (const Fall& fall : {Fall{"plate-shatter", 0.05, 400.0, 0.0}, Fall{"teapot-drop", 0.08, 200.0, 0.04}}) {
    const std::filesystem::path folder(SMITHEREENS_SOURCE_DIR "/resources/scenes");
    const auto file = modeling::loadScene(folder / (std::string(fall.scene) + ".scene.json"));
    REQUIRE(file);
    auto built = modeling::build(file->scene, folder);
    REQUIRE(built);
    auto created = sim::Simulation::create(std::move(built->network), built->conditions.environment,
                                           built->conditions.tracks, built->conditions.settings);
    REQUIRE(created);
    sim::Simulation& simulation = **created;
    const sim::Network& network = simulation.network();
    sim::SurfaceBuilder shards(network);
    sim::SurfaceBuilder given(network, LooseNodes::givenToNeighbours);
    const double whole = total(volumes(shards.build(sim::momentAtRest(network))));
    std::size_t pieces = 0;
    for (double time = fall.hastened; time <= fall.until; time += 1.0 / fall.frames) {
      REQUIRE(simulation.advanceTo(time));
      const sim::Snapshot moment = simulation.snapshot();
      for (sim::SurfaceBuilder* builder : {&shards, &given}) {
        const auto byFragment = volumes(builder->build(moment));
        CHECK(total(byFragment) == Approx(whole).epsilon(0.02));
        for (const auto& [fragment, volume] : byFragment) CHECK(volume > 0.0);
        pieces = std::max(pieces, byFragment.size());
      }
    }
    INFO(fall.scene);
    CHECK(pieces > 20);
  }
}

}  // namespace
