#include <cmath>
#include <numbers>

#include <catch2/catch.hpp>

#include "sim/methods/method_names.h"
#include "tests/support/crash.h"

/// The methods beside the leapfrog family: what they are exact to, and that breaks end their steps.
namespace {

using sim::Method;
using sim::Vec3;

struct Ordered {
  Method method;
  double order;
};

/// Every method with positions and velocities of the same moment.
Ordered anyMethod() {
  return GENERATE(Ordered{Method::rungeKutta, 4.0}, Ordered{Method::implicitMidpoint, 2.0},
                  Ordered{Method::implicitEuler, 1.0});
}

sim::Settings stepping(Method method, double step) {
  sim::Settings settings = tests::losslessSettings();
  settings.method = method;
  settings.step = step;
  return settings;
}

/// Read from errors at a step and its half: the next term of the error changes it by a few per cent.
void checkOrder(double coarse, double fine, double order) {
  CHECK(std::log2(coarse / fine) == Approx(order).margin(0.1));
}

TEST_CASE("a damped spring comes near the closed form with the method's order") {
  const auto [method, order] = anyMethod();
  INFO(sim::nameOf(method));
  constexpr double kStiffness = 1000.0;
  constexpr double kDamping = 4.0;
  constexpr double kUntil = 0.2;
  // x'' = -2 gamma x' - omega0^2 x with the reduced mass 1/2, from rest at 0.1.
  const double gamma = kDamping;
  const double omega = std::sqrt(2.0 * kStiffness - gamma * gamma);
  const auto errorWith = [&](int steps) {
    const auto spring =
        tests::simulation(tests::twoNodes({.stiffness = kStiffness, .damping = kDamping, .distance = 1.1}),
                          stepping(method, kUntil / steps));
    for (int n = 0; n < steps; ++n) REQUIRE(spring->stepOnce().ok());
    const sim::Snapshot snapshot = spring->snapshot();
    const double t = snapshot.time;
    const double exact =
        0.1 * std::exp(-gamma * t) * (std::cos(omega * t) + gamma / omega * std::sin(omega * t));
    // What the damper took is right with the same order.
    const double scale = 0.5 * kStiffness * 0.01;
    return std::pair(std::abs((snapshot.positions[1] - snapshot.positions[0]).norm() - 1.0 - exact),
                     std::abs(snapshot.ledger.energy.residual) / scale);
  };
  const auto coarse = errorWith(400);
  const auto fine = errorWith(800);
  checkOrder(coarse.first, fine.first, order);
  // The midpoint rule keeps a linear spring's account to rounding.
  CHECK(fine.second < std::max(1e-9, coarse.second / std::pow(2.0, order - 0.2)));
}

TEST_CASE("a chain swings in its modes with the method's order") {
  const auto [method, order] = anyMethod();
  INFO(sim::nameOf(method));
  // Along itself a chain is linear: nodes swing as cos(q (j + 1/2)) with omega = 2 sqrt(k / m) sin(q / 2).
  constexpr unsigned kNodes = 12;
  constexpr double kUntil = 0.4;
  constexpr double q = 3.0 * std::numbers::pi / kNodes;
  const double omega = 2.0 * std::sqrt(1000.0) * std::sin(q / 2.0);
  const auto errorWith = [&](int steps) {
    sim::Blueprint bar = tests::chain(kNodes);
    for (unsigned j = 0; j < kNodes; ++j) bar.nodes[j].velocity.x() = std::cos(q * (j + 0.5));
    const auto chain = tests::simulation(std::move(bar), stepping(method, kUntil / steps));
    for (int n = 0; n < steps; ++n) REQUIRE(chain->stepOnce().ok());
    const sim::Snapshot snapshot = chain->snapshot();
    double worst = 0.0;
    for (unsigned j = 0; j < kNodes; ++j) {
      const double exact = j + std::cos(q * (j + 0.5)) * std::sin(omega * snapshot.time) / omega;
      worst = std::max(worst, std::abs(snapshot.positions[j].x() - exact));
    }
    return worst;
  };
  // So many steps that the next term of the error is small in the stiffest of its modes, too.
  checkOrder(errorWith(400), errorWith(800), order);
}

TEST_CASE("momenta stay with every method") {
  const Method method = anyMethod().method;
  INFO(sim::nameOf(method));
  const auto tangle = tests::simulation(tests::randomNetwork(60, 3, 20.0), stepping(method, 2e-4));
  const sim::LedgerRow before = tangle->snapshot().ledger;
  for (int n = 0; n < 300; ++n) REQUIRE(tangle->stepOnce().ok());
  const sim::LedgerRow after = tangle->snapshot().ledger;
  // Forces on both ends of a bond are opposite to the last bit, so linear momentum stays to rounding; the
  // angular one to the method's own order where it isn't kept by construction.
  double scale = 0.0;
  for (const Vec3& velocity : tangle->snapshot().velocities) scale += velocity.norm();
  CHECK((after.linearMomentum - before.linearMomentum).norm() < 1e-10 * scale);
  if (method != Method::implicitEuler)
    CHECK((after.angularMomentum - before.angularMomentum).norm() < 1e-4 * scale);
}

TEST_CASE("a spring breaks when it reaches its threshold, and what was swinging flies on") {
  const Method method = anyMethod().method;
  INFO(sim::nameOf(method));
  constexpr double kSpeed = 4.0;
  constexpr double kThreshold = 0.05;
  const double omega = std::sqrt(2.0 * 1000.0);
  const double broken = std::asin(kThreshold * omega / kSpeed) / omega;
  // A fine step against the method's own error; the break falls anywhere within one.
  const double step = broken / 50.37;
  const auto spring =
      tests::simulation(tests::twoNodes({.approach = -kSpeed, .threshold = static_cast<float>(kThreshold)}),
                        stepping(method, step));
  tests::run(*spring, 2.0 * broken);
  const auto events = spring->drainBreakEvents();
  REQUIRE(events.size() == 1);
  // Located to 1e-6 of the strain, which is 1e-6 of the time and a little, beside the error of the method.
  const double own = method == Method::rungeKutta ? 3e-6 : method == Method::implicitMidpoint ? 3e-4 : 3e-2;
  CHECK(events[0].time == Approx(broken).epsilon(own));
  CHECK(static_cast<double>(events[0].strain) == Approx(kThreshold).epsilon(2e-6));
  const sim::Snapshot snapshot = spring->snapshot();
  const double apart = (snapshot.positions[1] - snapshot.positions[0]).norm();
  const double flying = kSpeed * std::cos(omega * broken);
  CHECK(apart == Approx(1.0 + kThreshold + flying * (snapshot.time - broken)).epsilon(own));
  CHECK(snapshot.ledger.energy.released == Approx(500.0 * kThreshold * kThreshold).epsilon(4e-6));
  CHECK(std::abs(snapshot.ledger.energy.residual) < own * 500.0 * kThreshold * kThreshold);
}

TEST_CASE("a bar pulled at constant speed breaks at its moment") {
  const Method method = anyMethod().method;
  INFO(sim::nameOf(method));
  sim::Blueprint bar = tests::twoNodes({.approach = -3.0, .threshold = 0.1F});
  for (sim::Blueprint::Node& node : bar.nodes) node.mass = std::numeric_limits<double>::infinity();
  const auto pulled = tests::simulation(std::move(bar), stepping(method, 7.3e-3));
  tests::run(*pulled, 0.1);
  const auto events = pulled->drainBreakEvents();
  REQUIRE(events.size() == 1);
  CHECK(events[0].time == Approx(static_cast<double>(0.1F) / 3.0).epsilon(2e-6));
}

TEST_CASE("what is overstretched from the start breaks before anything moves") {
  const Method method = anyMethod().method;
  const auto torn =
      tests::simulation(tests::twoNodes({.distance = 1.2, .threshold = 0.1}), stepping(method, 1e-3));
  REQUIRE(torn->stepOnce().ok());
  REQUIRE(torn->brokenBondCount() == 1);
  CHECK(torn->drainBreakEvents()[0].time == 0.0);
  CHECK(torn->snapshot().positions[1].x() == 1.2);
}

TEST_CASE("blocks that break each other never raise the energy, and keep their momentum") {
  const Method method = anyMethod().method;
  INFO(sim::nameOf(method));
  tests::Block shape{.nx = 3, .ny = 2, .nz = 3, .youngsModulus = 1e7, .dampingTime = 1e-5};
  shape.material.thresholdMean = 0.01;
  shape.material.thresholdSpread = 0.3;
  sim::Settings settings;
  settings.method = method;
  settings.threads = 1;
  const auto crash = tests::simulation(tests::twoBlocks(shape, 0.5, 400.0), settings);
  const sim::LedgerRow before = crash->snapshot().ledger;
  tests::run(*crash, 0.003);
  const sim::LedgerRow after = crash->snapshot().ledger;
  REQUIRE(crash->brokenBondCount() > 20);
  CHECK(crash->maxRise() < 0.005);
  CHECK((after.linearMomentum - before.linearMomentum).norm() <
        1e-10 * std::sqrt(2.0 * before.energy.kinetic * 72.0));
}

TEST_CASE("every method gives the same bits on any number of threads, and when resumed") {
  const Method method = anyMethod().method;
  INFO(sim::nameOf(method));
  const auto whole = tests::crash({.method = method});
  constexpr double kUntil = 0.0016;
  tests::run(*whole, kUntil);
  REQUIRE(whole->brokenBondCount() > 20);
  const auto first = tests::crash({.threads = 2, .method = method});
  const std::uint64_t cut = whole->stepCount() / 2;
  for (std::uint64_t n = 0; n < cut; ++n) REQUIRE(first->stepOnce().ok());
  const auto resumed = tests::crash({.threads = 3, .method = method});
  REQUIRE(resumed->restore(first->checkpoint()).ok());
  tests::run(*resumed, kUntil);
  CHECK(resumed->stateHash() == whole->stateHash());
  CHECK(resumed->snapshot().ledger.energy.dissipated == whole->snapshot().ledger.energy.dissipated);
}

}  // namespace
