#include <algorithm>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "tests/support/spring_network.h"

// Loads that come slowly on what is rigid or asleep (docs/numerics.md, "What is skipped").

namespace {

using sim::Vec3;

/// A bar of so many layers of cells, on two rollers, and a third one that comes down on its middle.
struct Bending {
  unsigned layers = 1;
  double speed = 5.0;  ///< cm/s
  bool rigid = true;

  std::unique_ptr<sim::Simulation> simulation() const {
    tests::Block bar{.nx = 12,
                     .ny = 2,
                     .nz = layers,
                     .spacing = 0.5,
                     .youngsModulus = 1e9,
                     .density = 1.0,
                     .dampingTime = 1e-6,
                     .material = {.name = "stone"}};
    bar.material.thresholdMean = 2e-3;
    bar.corner = Vec3(-3.0, -0.5, 0.0);
    const double top = 0.5 * layers;
    sim::Environment environment;
    const auto roller = [&](double x, double z) {
      sim::Collider collider;
      collider.name = "roller";
      collider.shape = sim::CylinderShape{0.5, 2.0};
      collider.position = Vec3(x, 0.0, z);
      collider.rotation = Eigen::AngleAxisd(1.5707963267948966, Vec3::UnitX());
      collider.dampingRatio = 0.8;
      environment.colliders.push_back(collider);
    };
    roller(-2.5, -0.5);
    roller(2.5, -0.5);
    roller(0.0, top + 0.5 + kAir);
    sim::Track down{.target = sim::TrackTarget::colliderPosition, .object = 2, .keys = {}};
    down.keys.push_back({0.0, Vec3(0.0, 0.0, top + 0.5 + kAir)});
    down.keys.push_back({kWay / speed, Vec3(0.0, 0.0, top + 0.5 + kAir - kWay)});
    sim::Settings settings = tests::losslessSettings();
    settings.skip.rigid = rigid;
    return tests::simulation(tests::block(bar), settings, environment, {down});
  }
  /// cm: how far the third one has come when the bar breaks; nothing if it does not.
  double wayToBreak() const {
    const auto run = simulation();
    while (run->time() < kWay / speed && run->brokenBondCount() == 0) REQUIRE(run->stepOnce().ok());
    return run->brokenBondCount() > 0 ? speed * run->time() - kAir : 0.0;
  }

  static constexpr double kAir = 0.005;  ///< cm
  static constexpr double kWay = 0.3;    ///< cm
};

}  // namespace

TEST_CASE("a bar breaks under a slow press when it would if nothing ever went rigid") {
  const unsigned layers = GENERATE(1U, 2U, 4U);
  const double speed = GENERATE(5.0, 1.0);
  INFO(layers << " layers, " << speed << " cm/s");
  const double way = Bending{layers, speed, true}.wayToBreak();
  const double wayWithoutSkipping = Bending{layers, speed, false}.wayToBreak();
  REQUIRE(wayWithoutSkipping > 0.0);
  // The work is the way squared: five per cent of it.
  CHECK(way == Approx(wayWithoutSkipping).epsilon(0.025));
}

TEST_CASE("what lies there unloaded goes rigid all the same") {
  Bending waiting{.layers = 2, .speed = 1e-3};
  const auto run = waiting.simulation();
  tests::run(*run, 0.2);
  const sim::Snapshot there = run->snapshot();
  CHECK(there.fragments[0].state != sim::FragmentState::deforming);
}

TEST_CASE("a sleeper wakes when a held part is lowered on it, however slowly") {
  tests::Block lower{.nx = 4, .ny = 2, .nz = 2, .spacing = 0.5, .youngsModulus = 1e8, .dampingTime = 2e-5};
  sim::Blueprint blueprint = tests::block(lower);
  tests::Block plate{.nx = 4, .ny = 2, .nz = 1, .spacing = 0.5, .youngsModulus = 1e8};
  plate.corner = Vec3(0.0, 0.0, 1.02);
  plate.velocity = Vec3(0.0, 0.0, -0.05);
  sim::Blueprint above = tests::block(plate);
  for (sim::Blueprint::Node& node : above.nodes) node.mass = std::numeric_limits<double>::infinity();
  tests::append(blueprint, above);
  sim::Environment environment = tests::earth();
  environment.colliders[0].dampingRatio = 0.8;
  const auto run = tests::simulation(std::move(blueprint), tests::losslessSettings(), environment);
  tests::run(*run, 0.8);
  // It has been pressed for a quarter of a second, by a hundredth of a centimetre.
  const sim::Snapshot end = run->snapshot();
  CHECK(end.fragments[0].state == sim::FragmentState::deforming);
  double highest = 0.0;
  for (std::size_t n = 0; n < end.positions.size(); ++n) {
    if (run->network().nodeParts[n] == 0) highest = std::max(highest, end.positions[n].z());
  }
  CHECK(highest < 0.99);
}
