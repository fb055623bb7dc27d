#include <algorithm>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "tests/support/spring_network.h"

// What begins inside something, and how it gets out (docs/numerics.md, Contact 12).

namespace {

using sim::Vec3;

/// Breaks where it is thrown.
tests::Block brittle(const Vec3& corner) {
  tests::Block block{
      .nx = 3, .ny = 3, .nz = 2, .youngsModulus = 1e9, .dampingTime = 1e-6, .material = {.name = "stone"}};
  block.material.thresholdMean = 1e-3;
  block.corner = corner;
  return block;
}

double fastestOf(const sim::Simulation& simulation) {
  double fastest = 0.0;
  for (const Vec3& velocity : simulation.snapshot().velocities) fastest = std::max(fastest, velocity.norm());
  return fastest;
}

double lowestOf(const sim::Simulation& simulation) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Vec3& position : simulation.snapshot().positions) lowest = std::min(lowest, position.z());
  return lowest;
}

/// The fastest that any node is on the way.
double fastestUntil(sim::Simulation& simulation, double time) {
  double fastest = 0.0;
  while (simulation.time() < time) {
    tests::run(simulation, simulation.time() + 0.002);
    fastest = std::max(fastest, fastestOf(simulation));
  }
  return fastest;
}

sim::Collider boxAt(const Vec3& position, const Vec3& halfSize) {
  sim::Collider box;
  box.name = "box";
  box.shape = sim::BoxShape{halfSize};
  box.position = position;
  return box;
}

}  // namespace

TEST_CASE("what begins in the floor comes out slowly, unbroken, and lies on it") {
  const double depth = GENERATE(0.001, 0.01, 0.05, 0.5);
  INFO(depth);
  const auto run = tests::simulation(tests::block(brittle(Vec3(0.0, 0.0, -depth))), tests::losslessSettings(),
                                     tests::earth());
  CHECK(fastestUntil(*run, 0.05 + depth / 3.0) < 10.0);
  CHECK(run->brokenBondCount() == 0);
  CHECK(run->maxRise() < 0.005);
  tests::run(*run, run->time() + 0.2);
  CHECK(std::abs(lowestOf(*run)) < 0.01);
}

TEST_CASE("by every method, what begins in the floor is let out slowly") {
  const auto method = GENERATE(sim::Method::forwardEuler, sim::Method::symplecticEuler,
                               sim::Method::rungeKutta, sim::Method::implicitMidpoint);
  sim::Settings settings = tests::losslessSettings();
  settings.method = method;
  const auto run = tests::simulation(tests::block(brittle(Vec3(0.0, 0.0, -0.05))), settings, tests::earth());
  CHECK(fastestUntil(*run, 0.03) < 10.0);
  CHECK(run->brokenBondCount() == 0);
  CHECK(run->maxRise() < 0.005);
}

TEST_CASE("what has no one way out is neither torn apart nor thrown") {
  sim::Environment environment;
  environment.gravity = Vec3::Zero();
  SECTION("across a wall that is narrower than it is") {
    environment.colliders.push_back(boxAt(Vec3(1.5, 1.5, 1.0), Vec3(0.8, 9.0, 9.0)));
  }
  SECTION("across a thin wall, with its middle in the middle") {
    environment.colliders.push_back(boxAt(Vec3(2.0, 1.5, 1.0), Vec3(0.9, 9.0, 9.0)));
  }
  SECTION("longer than the box that it stands in") {
    environment.colliders.push_back(boxAt(Vec3(1.5, 1.5, 1.0), Vec3(1.2, 2.0, 2.0)));
  }
  SECTION("in the middle of a ball") {
    sim::Collider ball;
    ball.name = "ball";
    ball.shape = sim::SphereShape{.radius = 5.0};
    ball.position = Vec3(1.5, 1.5, 1.0);
    environment.colliders.push_back(ball);
  }
  SECTION("about a small ball") {
    sim::Collider ball;
    ball.name = "ball";
    ball.shape = sim::SphereShape{.radius = 1.2};
    ball.position = Vec3(1.5, 1.5, 1.0);
    environment.colliders.push_back(ball);
  }
  SECTION("between walls that are too near each other") {
    environment.colliders.push_back(boxAt(Vec3(-4.7, 1.5, 1.0), Vec3(5.0, 9.0, 9.0)));
    environment.colliders.push_back(boxAt(Vec3(7.7, 1.5, 1.0), Vec3(5.0, 9.0, 9.0)));
  }
  const auto run =
      tests::simulation(tests::block(brittle(Vec3::Zero())), tests::losslessSettings(), environment);
  CHECK(fastestUntil(*run, 0.5) < 10.0);
  CHECK(run->brokenBondCount() == 0);
}

TEST_CASE("a floor that is raised between two takes lifts what lies on it, and does not throw it") {
  sim::Environment environment = tests::earth();
  environment.colliders[0].dampingRatio = 0.8;
  const auto before =
      tests::simulation(tests::block(brittle(Vec3::Zero())), tests::losslessSettings(), environment);
  tests::run(*before, 0.05);
  environment.colliders[0].position.z() = 0.3;
  const auto after =
      tests::simulation(tests::block(brittle(Vec3::Zero())), tests::losslessSettings(), environment);
  REQUIRE(after->takeOver(*before).ok());
  CHECK(fastestUntil(*after, 0.25) < 10.0);
  CHECK(after->brokenBondCount() == 0);
  CHECK(std::abs(lowestOf(*after) - 0.3) < 0.01);
}

TEST_CASE("a part that is held at one end is not bent out of the floor") {
  sim::Blueprint blueprint = tests::block(brittle(Vec3(0.0, 0.0, -0.3)));
  for (sim::Blueprint::Node& node : blueprint.nodes) {
    if (node.position.x() < 0.5) node.mass = std::numeric_limits<double>::infinity();
  }
  const auto run = tests::simulation(std::move(blueprint), tests::losslessSettings(), tests::earth());
  CHECK(fastestUntil(*run, 0.1) < 10.0);
  CHECK(run->brokenBondCount() == 0);
}

TEST_CASE("a floor that leaps up, or begins to act, lifts what is on it slowly") {
  sim::Environment environment = tests::earth();
  environment.colliders[0].dampingRatio = 0.8;
  std::vector<sim::Track> tracks;
  SECTION("leaps") {
    sim::Track up{.target = sim::TrackTarget::colliderPosition,
                  .object = 0,
                  .interpolation = sim::Interpolation::step,
                  .keys = {}};
    up.keys.push_back({0.0, Vec3::Zero()});
    up.keys.push_back({0.05, Vec3(0.0, 0.0, 0.3)});
    tracks.push_back(up);
  }
  SECTION("begins to act") {
    sim::Collider second = environment.colliders[0];
    second.position.z() = 0.3;
    second.activeFrom = 0.05;
    environment.colliders.push_back(second);
  }
  const auto run =
      tests::simulation(tests::block(brittle(Vec3::Zero())), tests::losslessSettings(), environment, tracks);
  CHECK(fastestUntil(*run, 0.3) < 10.0);
  CHECK(run->brokenBondCount() == 0);
  CHECK(std::abs(lowestOf(*run) - 0.3) < 0.01);
}

TEST_CASE("a run that goes on while something is let out is the same to the bit") {
  const auto make = [] {
    return tests::simulation(tests::block(brittle(Vec3(0.0, 0.0, -0.1))), tests::losslessSettings(),
                             tests::earth());
  };
  const auto whole = make();
  tests::run(*whole, 0.01);
  const std::vector<std::byte> half = whole->checkpoint();
  tests::run(*whole, 0.05);
  const auto resumed = make();
  REQUIRE(resumed->restore(half).ok());
  tests::run(*resumed, 0.05);
  CHECK(resumed->stateHash() == whole->stateHash());
}

TEST_CASE("two bodies that begin in one place, or in part, are not thrown apart") {
  const double apart = GENERATE(0.0, 0.3, 1.0, 1.9);
  INFO(apart);
  sim::Blueprint blueprint = tests::block(brittle(Vec3::Zero()));
  tests::append(blueprint, tests::block(brittle(Vec3(0.2, 0.1, apart))));
  const auto run = tests::simulation(std::move(blueprint), tests::losslessSettings());
  // Nothing pushes, so that only rounding moves them.
  CHECK(fastestUntil(*run, 0.1) < 1e-6);
  CHECK(run->brokenBondCount() == 0);
}

TEST_CASE("a body that begins a little inside another rests on it, as deep as it began") {
  constexpr double kDepth = 0.1;
  sim::Blueprint blueprint = tests::block(brittle(Vec3::Zero()));
  tests::append(blueprint, tests::block(brittle(Vec3(0.2, 0.1, 2.0 - kDepth))));
  const std::size_t half = blueprint.nodes.size() / 2;
  sim::Settings settings = tests::losslessSettings();
  settings.contact.dampingRatio = 0.5;
  const auto run = tests::simulation(std::move(blueprint), settings, tests::earth());
  CHECK(fastestUntil(*run, 0.4) < 10.0);
  const sim::Snapshot end = run->snapshot();
  const double gap = end.positions[half].z() - end.positions[0].z() - 2.0;
  CHECK(gap > -kDepth - 0.02);
  CHECK(gap < 0.03);
}
