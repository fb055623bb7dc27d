#include <cmath>

#include <catch2/catch.hpp>

#include "sim/kernel/bond_layout.h"
#include "tests/support/spring_network.h"

namespace {

using sim::Vec3;

/// A bar along z whose ends are pulled apart and let go again by a weak field of its own: the upper half gets
/// the given speed up, the lower half down, and damping brings it to rest.
tests::Block soft(double yieldStrain) {
  tests::Block shape{.nx = 2, .ny = 2, .nz = 8, .youngsModulus = 1e6, .dampingTime = 3e-4};
  shape.material.yieldStrain = yieldStrain;
  shape.material.flowRate = 2e3;
  return shape;
}

double lengthAtRest(double yieldStrain, double speed) {
  sim::Blueprint bar = tests::block(soft(yieldStrain));
  for (sim::Blueprint::Node& node : bar.nodes) node.velocity.z() = speed * (node.position.z() / 4.0 - 1.0);
  const auto stretched = tests::simulation(std::move(bar), tests::losslessSettings());
  tests::run(*stretched, 0.3);
  const sim::Snapshot snapshot = stretched->snapshot();
  CHECK(snapshot.ledger.energy.kinetic < 1e-3);
  double lowest = 1e9;
  double highest = -1e9;
  for (const Vec3& position : snapshot.positions) {
    lowest = std::min(lowest, position.z());
    highest = std::max(highest, position.z());
  }
  return highest - lowest;
}

TEST_CASE("a bar stretched past yield keeps a set, and below yield does not") {
  // Sound speed is sqrt(E / rho) = 1000 cm/s: ends pulled apart at +-s strain the middle by some s / 1000.
  CHECK(lengthAtRest(0.02, 200.0) > 8.0 * 1.01);
  CHECK(lengthAtRest(0.02, -200.0) < 8.0 * 0.99);
  CHECK(lengthAtRest(0.5, 200.0) == Approx(8.0).epsilon(1e-3));
  CHECK(lengthAtRest(0.02, 5.0) == Approx(8.0).epsilon(1e-3));
}

TEST_CASE("a spring's strain beyond yield decays at the flow rate") {
  // Two held nodes: the excess e shrinks by the share rate * h each step, so that the rest length goes to
  // where the strain is the yield strain.
  constexpr double kLength = 1.2;
  constexpr double kYield = 0.05;
  constexpr double kRate = 100.0;
  constexpr double kStep = 1e-4;
  sim::Blueprint pair = tests::twoNodes({.distance = kLength});
  for (sim::Blueprint::Node& node : pair.nodes) node.mass = std::numeric_limits<double>::infinity();
  pair.materials[0].yieldStrain = kYield;
  pair.materials[0].flowRate = kRate;
  sim::Settings settings = tests::losslessSettings();
  settings.step = kStep;
  const auto held = tests::simulation(std::move(pair), settings);
  double rest = 1.0;
  for (int n = 0; n < 500; ++n) {
    REQUIRE(held->stepOnce().ok());
    rest += kRate * kStep * std::max(0.0, kLength - rest - kYield * rest);
    const double extension = kLength - rest;
    REQUIRE(held->snapshot().ledger.energy.elastic ==
            Approx(0.5 * 1000.0 * extension * extension).epsilon(1e-12));
  }
  CHECK(rest == Approx(kLength / (1.0 + kYield)).epsilon(1e-2));
  // What the spring gave up was dissipated, exactly.
  const sim::Energy energy = held->snapshot().ledger.energy;
  CHECK(energy.dissipated == Approx(0.5 * 1000.0 * 0.04 - energy.elastic).epsilon(1e-12));
}

TEST_CASE("the two ends of a plastic bond keep one rest length") {
  // If the copies drifted apart, forces would no longer be equal and opposite: momentum tells at once.
  sim::Blueprint tangle = tests::randomNetwork(80, 3, 50.0, 0.3);
  tangle.materials[0].yieldStrain = 0.02;
  tangle.materials[0].flowRate = 200.0;
  sim::Settings settings = tests::losslessSettings();
  settings.step = 5e-4;
  const auto flowing = tests::simulation(std::move(tangle), settings);
  const Vec3 before = flowing->snapshot().ledger.linearMomentum;
  const Vec3 spinBefore = flowing->snapshot().ledger.angularMomentum;
  tests::run(*flowing, 0.5);
  const sim::LedgerRow row = flowing->snapshot().ledger;
  CHECK(row.energy.dissipated > 1.0);
  CHECK((row.linearMomentum - before).norm() < 1e-10 * 80.0 * 50.0);
  CHECK((row.angularMomentum - spinBefore).norm() < 1e-10 * 80.0 * 50.0 * 4.0);
}

TEST_CASE("a plastic bond breaks by its stretch beyond the length it has flowed to") {
  sim::Blueprint pair = tests::twoNodes({.distance = 1.15, .threshold = 0.2});
  for (sim::Blueprint::Node& node : pair.nodes) node.mass = std::numeric_limits<double>::infinity();
  pair.nodes[1].velocity.x() = 0.1;
  pair.materials[0].yieldStrain = 0.05;
  pair.materials[0].flowRate = 1e3;
  sim::Settings settings = tests::losslessSettings();
  settings.step = 1e-4;
  const auto creeping = tests::simulation(std::move(pair), settings);
  // Drawn out by far more than a fifth of its first length, but slowly enough to flow all the way.
  tests::run(*creeping, 5.0);
  CHECK(creeping->brokenBondCount() == 0);
  CHECK((creeping->snapshot().positions[1].x()) == Approx(1.65));
}

}  // namespace
