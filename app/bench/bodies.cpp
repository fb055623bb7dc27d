#include "app/bench/bodies.h"

#include <numbers>

#include "modeling/scene/build.h"
#include "modeling/scene/resources.h"
#include "modeling/scene/scene_file.h"

namespace app {
namespace {

constexpr double kCell = 0.5;  // cm
/// rad/s: a fifth more than the spin at which the hoop of the tube of 60,000 nodes tears. Soon after a fifth
/// of the bonds has broken, no more do; with 300 rad/s three tenths go.
constexpr double kBurstSpin = 190.0;
constexpr double kBurstShare = 0.2;

/// What is measured is the work that deforming takes, so that nothing may rest or fly rigidly.
void keepDeforming(modeling::Scene& scene) {
  scene.solver.skip.sleep = false;
  scene.solver.skip.rigid = false;
}

modeling::Scene emptyScene(const char* name) {
  modeling::Scene scene;
  scene.name = name;
  modeling::SceneMaterial material;
  material.name = material.values.name = "ceramic";
  material.values.youngsModulus = 3e8;
  material.values.threshold.mean = 0.05;
  material.values.threshold.spread = 0.2;
  scene.materials.push_back(material);
  modeling::SceneCollider floor;
  floor.name = "floor";
  floor.form = modeling::FloorShape{};
  scene.environment.colliders.push_back(floor);
  keepDeforming(scene);
  return scene;
}

modeling::Part part(std::string name, modeling::PartShape shape, const sim::Vec3& position) {
  modeling::Part made;
  made.name = std::move(name);
  made.shape = std::move(shape);
  made.material = "ceramic";
  made.worldFromPart.position = position;
  return made;
}

}  // namespace

modeling::Scene tubeScene(int around, int along) {
  const double radius = around * kCell / (2.0 * std::numbers::pi);
  const double height = along * kCell;
  modeling::RevolutionShape tube;
  tube.outside = {
      modeling::straightSegment(modeling::Vec2(radius + kCell, height), modeling::Vec2(radius + kCell, 0.0))};
  tube.inside = {modeling::straightSegment(modeling::Vec2(radius, height), modeling::Vec2(radius, 0.0))};
  tube.resolution.counts = {around, along, 1};
  modeling::Scene scene = emptyScene("tube");
  scene.parts.push_back(part("tube", tube, sim::Vec3(0.0, 0.0, 10.0)));
  return scene;
}

modeling::Scene slabScene(int x, int y, int z) {
  modeling::SlabShape slab;
  slab.size = kCell * sim::Vec3(x, y, z);
  slab.resolution.counts = {x, y, z};
  modeling::Scene scene = emptyScene("slab");
  scene.parts.push_back(part("slab", slab, sim::Vec3(0.0, 0.0, 10.0)));
  return scene;
}

modeling::Scene burstingTubeScene(int around, int along) {
  modeling::Scene scene = tubeScene(around, along);
  scene.parts.front().angularVelocity = sim::Vec3(20.0, 0.0, kBurstSpin);
  return scene;
}

modeling::Scene looseCubesScene(int count) {
  modeling::Scene scene = emptyScene("loose cubes");
  constexpr int kCells = 2;
  constexpr double kPitch = kCells * kCell + 1.1 * kCell;
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      for (int k = 0; k < count; ++k) {
        modeling::SlabShape cube;
        cube.size = kCell * sim::Vec3(kCells, kCells, kCells);
        cube.resolution.counts = {kCells, kCells, kCells};
        const std::string name =
            "cube " + std::to_string(i) + ' ' + std::to_string(j) + ' ' + std::to_string(k);
        scene.parts.push_back(part(name, cube, kPitch * sim::Vec3(i, j, k) + sim::Vec3(0.0, 0.0, 0.5)));
        // Neighbours in a column move at each other, so that contacts form everywhere from the start.
        scene.parts.back().velocity = sim::Vec3(0.0, 0.0, k % 2 == 0 ? 100.0 : -100.0);
      }
    }
  }
  return scene;
}

sim::Result<std::vector<Body>> throughputBodies() {
  std::vector<Body> bodies;
  bodies.push_back({"tube, 3,700 nodes", tubeScene(60, 30)});
  auto teapot = modeling::loadScene(modeling::resourcesFolder() / "scenes" / "teapot-drop-fine.scene.json");
  if (!teapot) return teapot.problem();
  keepDeforming(teapot->scene);
  bodies.push_back({"teapot, 17,000 nodes", teapot->scene});
  bodies.push_back({"tube, 60,000 nodes", tubeScene(200, 150)});
  bodies.push_back({"slab, 500,000 nodes", slabScene(200, 50, 48)});
  bodies.push_back({"tube flying apart", burstingTubeScene(200, 150), kBurstShare});
  return bodies;
}

sim::Result<std::unique_ptr<sim::Simulation>> start(const modeling::Scene& scene, int threads) {
  auto built = modeling::build(scene, modeling::resourcesFolder() / "scenes");
  if (!built) return built.problem();
  built->conditions.settings.threads = threads;
  return sim::Simulation::create(std::move(built->network), built->conditions.environment,
                                 built->conditions.tracks, built->conditions.settings);
}

}  // namespace app
