#include "tests/ui/viewport_examples.h"

#include <algorithm>

#include "modeling/scene/build.h"
#include "sim/surface/surface_mesh.h"

namespace examples {
namespace {

sim::FragmentId fragmentAt(const sim::Vec3& rest) {
  if (rest.x() > 2.9 && rest.y() > 1.9 && rest.z() > 2.9) return 2;
  return rest.x() > 0.5 ? 1 : 0;
}

sim::Vec3 movedTo(const sim::Vec3& rest) {
  const sim::FragmentId fragment = fragmentAt(rest);
  if (fragment == 0) return {rest.x() * (1.0 + 0.01 * rest.z()), rest.y(), rest.z()};
  if (fragment == 2) return rest + sim::Vec3(1.5, 0.5, 1.5);
  const sim::Vec3 hinge(1.0, 0.0, 0.0);
  return hinge + sim::Vec3(0.6, 0.0, 0.0) + Eigen::AngleAxisd(0.35, sim::Vec3::UnitY()) * (rest - hinge);
}

void addFragments(const sim::Network& network, sim::Snapshot& moment, sim::Broken& broken) {
  for (const sim::FragmentId id : {0U, 1U, 2U}) {
    sim::Fragment fragment;
    sim::MovingFragment moving;
    fragment.id = moving.id = id;
    fragment.parent = id == 0 ? sim::kNone : 0;
    for (std::size_t node = 0; node < network.nodeCount(); ++node) {
      if (broken.fragmentOfNode[node] != id) continue;
      ++fragment.nodeCount;
      fragment.mass += network.masses[node];
      moving.centre += network.masses[node] * moment.positions[node];
    }
    moving.centre /= fragment.mass;
    broken.fragments.push_back(fragment);
    moment.fragments.push_back(moving);
  }
}

}  // namespace

modeling::Scene blockAndBall() {
  modeling::Scene scene;
  modeling::SceneMaterial clay;
  clay.name = "clay";
  clay.values.name = "clay";
  clay.values.youngsModulus = 1e7;
  clay.values.threshold.mean = 0.05;
  clay.values.look.outside = {0.80, 0.36, 0.24};
  clay.values.look.inside = {0.96, 0.86, 0.70};
  scene.materials.push_back(clay);
  modeling::Part block;
  block.name = "block";
  block.material = "clay";
  block.shape = modeling::SlabShape{sim::Vec3(6.0, 4.0, 3.0), {1.0, {}}};
  scene.parts.push_back(block);
  modeling::SceneCollider floor;
  floor.name = "floor";
  floor.form = modeling::FloorShape{};
  modeling::SceneCollider ball;
  ball.name = "ball";
  ball.form = modeling::SphereShape{1.5};
  ball.position = sim::Vec3(-6.0, 0.0, 1.5);
  scene.environment.colliders = {floor, ball};
  return scene;
}

ui::Shown brokenBlock() {
  const modeling::Scene scene = blockAndBall();
  auto built = std::make_shared<modeling::BuiltScene>(modeling::build(scene, {}).value());
  ui::Shown shown;
  shown.network = std::shared_ptr<const sim::Network>(built, &built->network);
  shown.scene = std::make_shared<const modeling::Scene>(scene);
  const sim::Network& network = *shown.network;
  sim::Snapshot moment = sim::momentAtRest(network);
  sim::Broken broken = *moment.broken;
  for (std::size_t node = 0; node < network.nodeCount(); ++node) {
    broken.fragmentOfNode[node] = fragmentAt(network.positions[node]);
    moment.positions[node] = movedTo(network.positions[node]);
  }
  for (sim::NodeIndex a = 0; a < network.nodeCount(); ++a) {
    for (sim::BondIndex bond = network.firstBond[a]; bond < network.firstBond[a + 1]; ++bond) {
      broken.bonds[bond] = broken.fragmentOfNode[a] != broken.fragmentOfNode[network.bondEnds[bond]];
    }
  }
  for (std::size_t cell = 0; cell < network.cellCount(); ++cell) {
    const auto& corners = network.cells[cell];
    broken.cells[cell] = std::any_of(corners.begin(), corners.end(), [&](sim::NodeIndex node) {
      return broken.fragmentOfNode[node] != broken.fragmentOfNode[corners[0]];
    });
  }
  addFragments(network, moment, broken);
  moment.broken = sim::sealed(std::move(broken));
  shown.moment = std::make_shared<const sim::Snapshot>(std::move(moment));
  return shown;
}

}  // namespace examples
