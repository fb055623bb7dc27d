#include <filesystem>
#include <map>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "sim/dynamics/simulation.h"
#include "sim/network/surface_mesh.h"

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
