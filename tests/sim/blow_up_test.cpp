#include <cmath>

#include <catch2/catch.hpp>

#include "tests/support/spring_network.h"

namespace {

void checkFinite(const sim::Simulation& simulation) {
  const sim::Snapshot snapshot = simulation.snapshot();
  for (const sim::Vec3& position : snapshot.positions) REQUIRE(position.allFinite());
  for (const sim::Vec3& velocity : snapshot.velocities) REQUIRE(velocity.allFinite());
  CHECK(std::isfinite(snapshot.ledger.energy.mechanical()));
  CHECK(std::isfinite(snapshot.ledger.energy.residual));
  CHECK(snapshot.ledger.linearMomentum.allFinite());
  CHECK(snapshot.ledger.angularMomentum.allFinite());
}

/// A quiet lower block and a stiffer upper one, far apart, which is let go at so many times its size.
sim::Blueprint softAndTorn(double stretch) {
  tests::Block soft{.youngsModulus = 1e4};
  soft.material.name = "jelly";
  tests::Block stiff{.youngsModulus = 1e8};
  stiff.material.name = "steel";
  stiff.corner.z() = 50.0;
  sim::Blueprint blueprint = tests::block(soft);
  const std::size_t first = blueprint.nodes.size();
  tests::append(blueprint, tests::block(stiff));
  blueprint.partNames = {"below", "above"};
  for (std::size_t n = first; n < blueprint.nodes.size(); ++n) {
    sim::Vec3& position = blueprint.nodes[n].position;
    position = stiff.corner + stretch * (position - stiff.corner);
  }
  return blueprint;
}

TEST_CASE("a blow-up is found, and the problem names node, part and material") {
  // Bonds stretched to many times their length pull sideways, too, which no step reckons with beforehand:
  // from hardly unstable to absurd.
  const double stretch = GENERATE(8.0, 100.0, 1e4, 1e8);
  const auto method = GENERATE(sim::Method::velocityVerlet, sim::Method::symplecticEuler);
  INFO(stretch << " " << sim::nameOf(method));
  sim::Settings settings = tests::losslessSettings();
  settings.method = method;
  settings.safety = 0.9;
  const auto wild = tests::simulation(softAndTorn(stretch), settings);
  sim::Status status = sim::Done{};
  int steps = 0;
  for (; status.ok() && steps < 20000; ++steps) {
    status = wild->stepOnce();
    checkFinite(*wild);
  }
  REQUIRE_FALSE(status.ok());
  const std::string line = status.problem().line();
  INFO(line);
  CHECK(line.find("node ") != std::string::npos);
  CHECK(line.find("'above'") != std::string::npos);
  CHECK(line.find("'steel'") != std::string::npos);
  CHECK(line.find("step") != std::string::npos);
  CHECK(status.problem().place.find("t = ") == 0);
}

TEST_CASE("a run that is only lively is not taken for a blow-up") {
  // Thrown, dropped, softened and stiffened again, pushed by a collider: energy comes from outside.
  tests::Block shape{.nx = 2, .ny = 2, .nz = 3, .youngsModulus = 1e6, .dampingTime = 1e-4};
  shape.corner.z() = 0.5;
  sim::Environment environment = tests::earth();
  sim::Track sneeze{.target = sim::TrackTarget::stiffnessScale,
                    .object = 0,
                    .interpolation = sim::Interpolation::step,
                    .keys = {}};
  sneeze.keys = {{0.0, sim::Vec3::UnitX()}, {0.1, 0.05 * sim::Vec3::UnitX()}, {0.2, sim::Vec3::UnitX()}};
  sim::Track kick{.target = sim::TrackTarget::colliderPosition,
                  .object = 0,
                  .interpolation = sim::Interpolation::linear,
                  .keys = {}};
  kick.keys = {{0.3, sim::Vec3::Zero()}, {0.33, sim::Vec3(0.0, 0.0, 6.0)}};
  const auto lively =
      tests::simulation(tests::block(shape), tests::losslessSettings(), environment, {sneeze, kick});
  tests::run(*lively, 0.5);
  checkFinite(*lively);
}

}  // namespace
