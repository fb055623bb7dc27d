#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "sim/base/random.h"
#include "sim/methods/method_names.h"
#include "tests/support/kernels.h"
#include "tests/support/spring_network.h"

namespace {

using sim::Method;
using sim::Vec3;

sim::Settings stepping(Method method, double step) {
  sim::Settings settings = tests::losslessSettings();
  settings.method = method;
  settings.step = step;
  return settings;
}

double extensionOf(const sim::Simulation& simulation) {
  const sim::Snapshot snapshot = simulation.snapshot();
  return (snapshot.positions[1] - snapshot.positions[0]).norm() - 1.0;
}

void steps(sim::Simulation& simulation, int count) {
  for (int n = 0; n < count; ++n) REQUIRE(simulation.stepOnce().ok());
}

constexpr double kStiffness = 1000.0;
constexpr double kReducedMass = 0.5;
const double kOmega = std::sqrt(kStiffness / kReducedMass);

TEST_CASE("a spring swings at the frequency that velocity Verlet is known to give it") {
  // Of x'' = -omega^2 x velocity Verlet makes A cos(n phi) with cos(phi) = 1 - (omega h)^2 / 2, exactly. What
  // is left is the rounding of lengths of 1 (1e-16 each step, growing like a random walk of the phase).
  const double step = 0.2 / kOmega;
  const auto spring =
      tests::simulation(tests::twoNodes({.distance = 1.1}), stepping(Method::velocityVerlet, step));
  const double phase = std::acos(1.0 - 0.5 * std::pow(kOmega * step, 2));
  for (int n = 1; n <= 1000; ++n) {
    REQUIRE(spring->stepOnce().ok());
    REQUIRE(extensionOf(*spring) == Approx(0.1 * std::cos(n * phase)).margin(1e-12));
  }
  // So the period is 2 pi sqrt(mu / k), shortened by (omega h)^2 / 24.
  const double period = 2.0 * std::numbers::pi / (phase / step);
  CHECK(period / (2.0 * std::numbers::pi * std::sqrt(kReducedMass / kStiffness)) ==
        Approx(1.0 - 0.04 / 24.0).margin(1e-5));
}

TEST_CASE("a damped spring's swing decays at the known rate") {
  // With the damper on the half-step velocity x_{n+1} = p x_n - q x_{n-1}, q = 1 - gamma h: the form
  // x_{n+1}^2 - p x_n x_{n+1} + q x_n^2 shrinks by q each step, and the amplitude by sqrt(q).
  constexpr double kDamping = 2.0;
  constexpr double kGamma = kDamping / kReducedMass;
  const double step = 0.05 / kOmega;
  const auto spring = tests::simulation(tests::twoNodes({.damping = kDamping, .distance = 1.1}),
                                        stepping(Method::velocityVerlet, step));
  const double q = 1.0 - kGamma * step;
  const double p = 1.0 + q - std::pow(kOmega * step, 2);
  const auto form = [&](double now, double next) { return next * next - p * now * next + q * now * now; };
  REQUIRE(spring->stepOnce().ok());
  double now = extensionOf(*spring);
  REQUIRE(spring->stepOnce().ok());
  double next = extensionOf(*spring);
  const double start = form(now, next);
  constexpr int kSteps = 400;
  for (int n = 0; n < kSteps; ++n) {
    REQUIRE(spring->stepOnce().ok());
    now = std::exchange(next, extensionOf(*spring));
  }
  const double decay = form(now, next) / start;
  CHECK(decay == Approx(std::pow(q, kSteps)).epsilon(1e-9));
  // Against the true exp(-gamma t): ln q = -gamma h - (gamma h)^2 / 2.
  const double time = kSteps * step;
  CHECK(decay == Approx(std::exp(-kGamma * time)).epsilon(0.6 * kGamma * kGamma * step * time));
}

TEST_CASE("a thrown node follows each method's own parabola") {
  constexpr double kStep = 1e-3;
  constexpr double kSpeed = 300.0;
  constexpr double kGravity = 981.0;
  constexpr int kSteps = 500;
  sim::Blueprint node;
  node.nodes.push_back({.position = Vec3(1.0, 2.0, 3.0), .velocity = Vec3(10.0, 0.0, kSpeed), .mass = 2.0});
  node.materials = {{.name = "stone"}};
  node.partNames = {"stone"};
  const auto fallen = [&](Method method) {
    const auto flight = tests::simulation(node, stepping(method, kStep), sim::Environment{});
    steps(*flight, kSteps);
    const sim::Snapshot snapshot = flight->snapshot();
    CHECK(snapshot.time == Approx(kSteps * kStep).epsilon(1e-14));
    CHECK(snapshot.positions[0].x() == Approx(1.0 + 10.0 * kSteps * kStep).epsilon(1e-12));
    CHECK(snapshot.velocities[0].z() == Approx(kSpeed - kGravity * kSteps * kStep).epsilon(1e-12));
    return (3.0 + kSpeed * kSteps * kStep - snapshot.positions[0].z()) / (kGravity * kStep * kStep / 2.0);
  };
  // Rounding: 500 sums of numbers up to 1e2 cm.
  constexpr double n = kSteps;
  CHECK(fallen(Method::velocityVerlet) == Approx(n * n).epsilon(1e-10));
  CHECK(fallen(Method::symplecticEuler) == Approx(n * (n + 1)).epsilon(1e-10));
  // The position moves by the old velocity (paper, "Dynamics").
  CHECK(fallen(Method::forwardEuler) == Approx(n * (n - 1)).epsilon(1e-10));
}

/// Where the second node of a spinning, swinging pair is after a tenth of a second.
Vec3 spunTo(Method method, double step, double damping) {
  sim::Blueprint pair = tests::twoNodes({.damping = damping, .distance = 1.2});
  pair.nodes[1].velocity = Vec3(0.0, 20.0, 3.0);
  const auto spin = tests::simulation(std::move(pair), stepping(method, step));
  steps(*spin, static_cast<int>(std::lround(0.1 / step)));
  return spin->snapshot().positions[1];
}

TEST_CASE("halving the step quarters velocity Verlet's error, and halves the Eulers'") {
  struct Case {
    Method method;
    double damping, step, order;
  };
  // Forward Euler needs damping to be stable at all. The order is read at steps short enough for the next
  // term of the error to change it by a few per cent.
  for (const Case& one :
       {Case{Method::velocityVerlet, 0.0, 1e-3, 2.0}, Case{Method::symplecticEuler, 0.0, 5e-5, 1.0},
        Case{Method::forwardEuler, 1.0, 5e-5, 1.0}}) {
    INFO(sim::nameOf(one.method));
    const Vec3 coarse = spunTo(one.method, one.step, one.damping);
    const Vec3 middle = spunTo(one.method, one.step / 2.0, one.damping);
    const Vec3 fine = spunTo(one.method, one.step / 4.0, one.damping);
    CHECK(std::log2((coarse - middle).norm() / (middle - fine).norm()) == Approx(one.order).margin(0.06));
  }
}

struct Momenta {
  Vec3 linear, angular;
  double linearScale, angularScale;  ///< sums of the sizes
};

Momenta momentaOf(const sim::Simulation& simulation) {
  const sim::Snapshot snapshot = simulation.snapshot();
  Momenta sum{snapshot.ledger.linearMomentum, snapshot.ledger.angularMomentum, 0.0, 0.0};
  for (std::size_t n = 0; n < snapshot.positions.size(); ++n) {
    const double size = simulation.network().masses[n] * snapshot.velocities[n].norm();
    sum.linearScale += size;
    sum.angularScale += size * snapshot.positions[n].norm();
  }
  return sum;
}

// Forces on a bond's two ends are equal and opposite to the last bit, so only the rounding of sums is left:
// 1e-16 a step and node. 1e-10 leaves room for some 1e5 steps.
constexpr double kMomentumTolerance = 1e-10;

TEST_CASE("nothing outside acts, so linear and angular momentum stay") {
  const Method method = GENERATE(Method::velocityVerlet, Method::symplecticEuler);
  const std::uint64_t seed = GENERATE(1, 2, 3);
  const std::string kernel = GENERATE(from_range(tests::kernelsHere()));
  INFO(sim::nameOf(method) << " " << kernel);
  const tests::ChosenKernel chosen(kernel);
  const auto tangle = tests::simulation(tests::randomNetwork(60, seed, 20.0), stepping(method, 1e-3));
  const Momenta before = momentaOf(*tangle);
  steps(*tangle, 2000);
  const Momenta after = momentaOf(*tangle);
  CHECK((after.linear - before.linear).norm() < kMomentumTolerance * before.linearScale);
  CHECK((after.angular - before.angular).norm() < kMomentumTolerance * before.angularScale);
}

TEST_CASE("breaking and contact with friction and damping leave linear momentum alone") {
  const std::uint64_t seed = GENERATE(4, 5, 6);
  tests::Block shape{.nx = 3, .ny = 2, .nz = 3, .dampingTime = 1e-5};
  shape.material.thresholdMean = 0.01;
  shape.material.thresholdSpread = 0.3;
  sim::Blueprint blocks = tests::twoBlocks(shape, 0.7, 300.0);
  for (sim::Blueprint::Node& node : blocks.nodes) node.velocity.x() += 10.0 * node.position.z();
  sim::Settings settings;
  settings.threads = 1;
  settings.seed = seed;
  const auto crash = tests::simulation(std::move(blocks), settings);
  const Momenta before = momentaOf(*crash);
  tests::run(*crash, 0.02);
  REQUIRE(crash->brokenBondCount() > 20);
  REQUIRE(crash->snapshot().ledger.energy.dissipated > 0.0);
  const Momenta after = momentaOf(*crash);
  CHECK((after.linear - before.linear).norm() < kMomentumTolerance * before.linearScale);
}

TEST_CASE("a step looks at each bond once, and labels nothing where nothing breaks") {
  const auto tangle = tests::simulation(tests::randomNetwork(60, 7), stepping(Method::velocityVerlet, 1e-3));
  steps(*tangle, 10);
  CHECK(tangle->work().bondsEvaluated == 10 * tangle->network().bondCount());
  CHECK(tangle->work().labelings == 0);
}

}  // namespace
