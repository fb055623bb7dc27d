#include <cmath>

#include <catch2/catch.hpp>

#include "sim/methods/method_names.h"
#include "sim/state/ledger.h"
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

/// A quiet lower block and a stiffer upper one, far apart, of which one node has this speed.
sim::Blueprint softAndStiff(double speed) {
  tests::Block soft{.youngsModulus = 1e4};
  soft.material.name = "jelly";
  tests::Block stiff{.youngsModulus = 1e8};
  stiff.material.name = "steel";
  stiff.corner.z() = 50.0;
  sim::Blueprint blueprint = tests::block(soft);
  tests::append(blueprint, tests::block(stiff));
  blueprint.partNames = {"below", "above"};
  blueprint.nodes.back().velocity.x() = speed;
  return blueprint;
}

TEST_CASE("what gets faster than light is found, and the problem names node, part and material") {
  const double speed = GENERATE(4e10, 1e20, 1e100);
  const auto method =
      GENERATE(sim::Method::velocityVerlet, sim::Method::symplecticEuler, sim::Method::rungeKutta);
  INFO(speed << " " << sim::nameOf(method));
  sim::Settings settings = tests::losslessSettings();
  settings.method = method;
  const auto wild = tests::simulation(softAndStiff(speed), settings);
  const sim::Status status = wild->stepOnce();
  checkFinite(*wild);
  REQUIRE_FALSE(status.ok());
  const std::string line = status.problem().line();
  INFO(line);
  CHECK(line.find("node ") != std::string::npos);
  CHECK(line.find("'above'") != std::string::npos);
  CHECK(line.find("'steel'") != std::string::npos);
  CHECK(line.find("step") != std::string::npos);
  CHECK(status.problem().place.find("t = ") == 0);
}

TEST_CASE(
    "far more energy than there was to have is a blow-up, and a rise counts only where all energy rises") {
  const sim::Network pair = tests::built(tests::twoNodes({}));
  sim::Ledger ledger(pair);
  const auto row = [](double kinetic) {
    sim::LedgerRow made;
    made.energy.kinetic = kinetic;
    return made;
  };
  ledger.begin(row(2.0), 1.5);
  CHECK(ledger.watch(row(2.2), 1.5));
  CHECK(ledger.maxRise() == 0.0);
  CHECK(ledger.watch(row(2.0), 1.9));
  CHECK(ledger.maxRise() == 0.0);
  CHECK(ledger.watch(row(4.0), 2.5));
  CHECK(ledger.maxRise() == Approx(1.0 / 4.0));
  CHECK_FALSE(ledger.watch(row(21.0), 20.0));
  CHECK_FALSE(ledger.watch(row(std::nan("")), 1.0));
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
