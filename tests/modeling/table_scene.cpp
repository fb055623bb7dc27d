#include "tests/modeling/table_scene.h"

#include <catch2/catch.hpp>

#include "modeling/scene/build.h"
#include "modeling/scene/scene_file.h"
#include "sim/methods/method_names.h"

namespace tests {
namespace {

const char* const kTable = R"({
  "smithereens": 1,
  "materials": {
    "jelly": {"youngsModulus": 1e6, "lossFactor": 1},
    "glass": {"youngsModulus": 1e7, "lossFactor": 0.4, "threshold": {"mean": 0.003, "spread": 0.2}}
  },
  "parts": [
    {"name": "block", "kind": "slab", "material": "jelly", "size": [2, 2, 2], "resolution": {"cellSize": 1}},
    {"name": "vase", "kind": "revolution", "material": "glass",
     "outside": [[[2, 5], [2, 0]], [[2, 0], [0, 0]]], "inside": [[[1.2, 5], [1.2, 0.8]], [[1.2, 0.8], [0, 0.8]]],
     "resolution": {"cellSize": 1, "counts": [8, null, 1]}, "worldFromPart": {"position": [10, 0, 0]}}
  ],
  "environment": {"colliders": [{"name": "floor", "kind": "floor", "dampingRatio": 0.8}]},
  "solver": {"contact": {"dampingRatio": 0.8}}
})";

/// The same with tracks from the start, and colliders that are moved.
const char* const kDriven = R"(tracks=[
  {"target": "gravity.scale", "keys": [[0, 1], [0.02, 3]]},
  {"target": "stiffness.scale", "keys": [[0.005, 1], [0.01, 0.8]], "interpolation": "smooth"},
  {"target": "gravity", "keys": [[0, [0, 0, -981]], [0.03, [50, 0, -981]]]},
  {"target": "collider.floor.position", "keys": [[0, [0, 0, 0]], [0.04, [0, 0, 0.3]]]}])";

}  // namespace

modeling::Scene tableScene(sim::Method method, bool driven) {
  std::vector<std::string> settings = {"solver.method=" + std::string(sim::nameOf(method))};
  if (driven) settings.emplace_back(kDriven);
  auto file = modeling::parseScene(kTable, "table", settings);
  if (!file) FAIL(file.problem().line());
  return file->scene;
}

std::unique_ptr<sim::Simulation> started(const modeling::Scene& scene, int threads) {
  auto built = modeling::build(scene, "");
  if (!built) FAIL(built.problem().line());
  built->conditions.settings.threads = threads;
  auto simulation = sim::Simulation::create(std::move(built->network), built->conditions.environment,
                                            built->conditions.tracks, built->conditions.settings);
  if (!simulation) FAIL(simulation.problem().line());
  return std::move(simulation).value();
}

}  // namespace tests
