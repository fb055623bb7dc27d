#include "tests/ui/window_scenes.h"

#include <QTest>

#include <catch2/catch.hpp>

#include "modeling/scene/build.h"
#include "sim/dynamics/simulation.h"
#include "sim/surface/surface_mesh.h"
#include "sim/take/frame_times.h"
#include "tests/support/grid_network.h"

namespace tests {

modeling::Scene fallingSlab() {
  modeling::Scene scene;
  modeling::SceneMaterial material;
  material.name = "rubber";
  material.values.name = "rubber";
  material.values.youngsModulus = 1e7;
  scene.materials.push_back(material);
  modeling::Part part;
  part.name = "slab";
  part.material = "rubber";
  part.shape = modeling::SlabShape{sim::Vec3(3.0, 3.0, 1.0), {1.0, {}}};
  part.worldFromPart.position.z() = 1.0;
  scene.parts.push_back(part);
  modeling::SceneCollider floor;
  floor.name = "floor";
  floor.form = modeling::FloorShape{};
  scene.environment.colliders.push_back(floor);
  scene.output = {100.0, 0.1};
  return scene;
}

modeling::Scene breakingSlab() {
  modeling::Scene scene = fallingSlab();
  scene.materials[0].values.threshold = modeling::ThresholdSpec{0.002, 0.3};
  scene.parts[0].velocity.z() = -400.0;
  scene.parts[0].worldFromPart.rotation.value = sim::Vec3(20.0, 10.0, 0.0);
  scene.parts[0].worldFromPart.position.z() = 3.0;
  scene.output = {400.0, 0.03};
  return scene;
}

std::uint64_t hashOfHeadlessRun(const modeling::Scene& scene) {
  auto built = modeling::build(scene, {});
  REQUIRE(built);
  auto simulation = sim::Simulation::create(built->network, std::move(built->conditions.environment),
                                            std::move(built->conditions.tracks), built->conditions.settings);
  REQUIRE(simulation);
  while (!sim::hasReached((*simulation)->time(), (*simulation)->step(), scene.output.duration))
    REQUIRE((*simulation)->stepOnce());
  return (*simulation)->stateHash();
}

std::shared_ptr<ui::Footage> stillFootage(const std::vector<double>& times,
                                          const std::vector<std::size_t>& breaks) {
  const auto network = std::make_shared<const sim::Network>(gridNetwork(1, 1, 1));
  auto footage = std::make_shared<ui::Footage>(network, modeling::Scene(), "nowhere.take");
  for (std::size_t frame = 0; frame < times.size(); ++frame) {
    auto moment = std::make_shared<sim::Snapshot>();
    moment->time = times[frame];
    moment->positions = network->positions;
    moment->velocities.assign(network->nodeCount(), sim::Vec3::Zero());
    moment->broken = sim::momentAtRest(*network).broken;
    std::vector<sim::BreakEvent> events(frame < breaks.size() ? breaks[frame] : 0);
    for (sim::BreakEvent& event : events) event.time = times[frame];
    footage->append(moment, ui::FrameNote{}, std::move(events));
  }
  return footage;
}

bool becomesTrue(const std::function<bool()>& condition) {
  return QTest::qWaitFor(condition, 60000);
}

void SessionFixture::load(const modeling::Scene& scene) {
  session.document().reset(scene, {});
  REQUIRE(becomesTrue([&] { return session.shown().moment != nullptr; }));
}

void SessionFixture::simulateToEnd() {
  session.simulate();
  REQUIRE(becomesTrue([&] { return session.run()->phase == ui::RunPhase::done; }));
}

}  // namespace tests
