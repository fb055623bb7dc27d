#include <cmath>
#include <functional>
#include <numbers>

#include <catch2/catch.hpp>

#include "sim/dynamics/simulation.h"
#include "tests/support/elastic_body.h"

using tests::Block;

namespace {

std::unique_ptr<sim::Simulation> weightless(sim::Blueprint body) {
  auto network = sim::buildNetwork(std::move(body), 1);
  REQUIRE(network);
  sim::Environment environment;
  environment.gravity = sim::Vec3::Zero();
  sim::Settings settings;
  settings.threads = 1;
  auto simulation = sim::Simulation::create(std::move(network).value(), environment, {}, settings);
  if (!simulation) FAIL(simulation.problem().line());
  return std::move(simulation).value();
}

/// Time at which `value` of the moving state has changed its sign `crossings` times, between steps by
/// straight lines.
double timeOfCrossing(sim::Simulation& simulation, int crossings,
                      const std::function<double(const sim::Snapshot&)>& value) {
  double lastTime = simulation.time();
  double last = value(simulation.snapshot());
  for (int step = 0; step < 100000; ++step) {
    REQUIRE(simulation.stepOnce());
    const double now = value(simulation.snapshot());
    if (now * last < 0.0 && --crossings == 0)
      return lastTime + (simulation.time() - lastTime) * last / (last - now);
    last = now;
    lastTime = simulation.time();
  }
  FAIL("it never swings back");
  return 0.0;
}

}  // namespace

TEST_CASE("two nodes on a bond swing with the period of their reduced mass") {
  modeling::AssemblyPart part;
  part.lattice.nodes = {sim::Vec3::Zero(), sim::Vec3(1.0, 0.0, 0.0)};
  part.looseBonds = {{0, 1, 500.0, 1.0, 0.0, 0}};
  part.looseMasses = {2.0, 3.0};
  part.looseVelocities = {sim::Vec3(0.03, 0.0, 0.0), sim::Vec3(-0.02, 0.0, 0.0)};
  auto blueprint = modeling::assemble({part}, {tests::plainMaterial()}, tests::unglued({part}));
  REQUIRE(blueprint);
  const auto simulation = weightless(std::move(blueprint).value());
  const double turn = timeOfCrossing(*simulation, 20, [](const sim::Snapshot& snapshot) {
    return snapshot.velocities[0].x() - snapshot.velocities[1].x();
  });
  // The 20th change of sign of the velocity, which starts at its peak, is at 39 quarter periods. Steps of
  // half the stable one, omega dt = 1, shorten Verlet's period by (omega dt)^2 / 24.
  const double period = 2.0 * std::numbers::pi * std::sqrt(1.2 / 500.0);
  const double phase = simulation->step() * std::sqrt(500.0 / 1.2);
  CHECK(turn == Approx(39.0 / 4.0 * period * (phase / 2.0) / std::asin(phase / 2.0)).epsilon(0.002));
  CHECK(phase < 1.05);
}

TEST_CASE("a free bar rings lengthwise at the speed of sound") {
  const Block bar{{2, 2, 40}, 0.5};
  modeling::Material material = tests::plainMaterial();
  material.lossFactor = 0.0;
  sim::Blueprint body = tests::bodyOf(bar.lattice(), material);
  const double length = bar.size().z();
  const auto mode = [&](const sim::Vec3& position) {
    return std::cos(std::numbers::pi * position.z() / length);
  };
  std::vector<double> weights;
  for (auto& node : body.nodes) {
    node.velocity.z() = 1e-3 * mode(node.position);
    weights.push_back(node.mass * mode(node.position));
  }
  const auto simulation = weightless(std::move(body));
  const double turn = timeOfCrossing(*simulation, 2, [&](const sim::Snapshot& snapshot) {
    double sum = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * snapshot.velocities[i].z();
    return sum;
  });
  // Three quarters of the period 2 L / c, c = sqrt(E / rho). Lateral inertia slows it by 2e-5; the lattice
  // and the step, 80 cells a wave, by less than that.
  CHECK(turn == Approx(0.75 * 2.0 * length / std::sqrt(1000.0 / 2.0)).epsilon(0.002));
}
